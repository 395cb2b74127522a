/* SPDX-License-Identifier: GPL-3.0-or-later
 * Output files appear complete or not at all, whatever goes wrong. */
#include <config.h>

#include <errno.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cmocka.h>

#include "output/file.h"
#include "tests/output/sample.h"

static void assert_text(const char *path, const char *wanted)
{
    size_t size;
    char *text = sample_read(path, &size);
    assert_non_null(text);
    assert_string_equal(text, wanted);
    free(text);
}

static bool write_text(struct place *p, const char *text)
{
    struct file *file = file_create(&p->log, p->path);
    if (!file)
        return false;
    file_write(file, text, strlen(text));
    return file_commit(file);
}

static void committed_file_is_there_and_hashed(void **state)
{
    struct place *p = *state;
    assert_true(write_text(p, "abc"));
    assert_text(p->path, "abc");
    assert_int_equal(sample_count(p->folder), 1);
    assert_int_equal(p->log.nentries, 1);
    assert_string_equal(p->log.entry[0].path, p->path);
    /* The standard's own example. */
    assert_string_equal(p->log.entry[0].sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

static void file_appears_at_commit_only(void **state)
{
    struct place *p = *state;
    assert_true(write_text(p, "old"));
    struct file *file = file_create(&p->log, p->path);
    assert_non_null(file);
    file_print(file, "%s", "new");
    assert_text(p->path, "old");
    assert_true(file_commit(file));
    assert_text(p->path, "new");
    assert_int_equal(p->log.nentries, 1);
    assert_int_equal(sample_count(p->folder), 1);
}

static void abandoned_file_leaves_the_old_one(void **state)
{
    struct place *p = *state;
    assert_true(write_text(p, "old"));
    struct file *file = file_create(&p->log, p->path);
    file_print(file, "new");
    file_abandon(file);
    assert_text(p->path, "old");
    assert_int_equal(sample_count(p->folder), 1);
}

/* More than a buffer, in pieces that do not divide it. */
static void long_file_arrives_whole(void **state)
{
    struct place *p = *state;
    struct file *file = file_create(&p->log, p->path);
    char piece[777];
    for (size_t i = 0; i < sizeof piece; i++)
        piece[i] = (char)('a' + i % 26);
    for (int i = 0; i < 1000; i++)
        file_write(file, piece, sizeof piece);
    assert_true(file_commit(file));
    size_t size;
    char *text = sample_read(p->path, &size);
    assert_int_equal(size, 1000 * sizeof piece);
    for (size_t i = 0; i < size; i++)
        assert_int_equal(text[i], piece[i % sizeof piece]);
    free(text);
}

/* A disk that is full: the system refuses to make the file longer. */
static void full_disk_leaves_nothing(void **state)
{
    struct place *p = *state;
    struct rlimit before, tight = {.rlim_cur = 100000, .rlim_max = RLIM_INFINITY};
    getrlimit(RLIMIT_FSIZE, &before);
    tight.rlim_max = before.rlim_max;
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &tight);
    struct file *file = file_create(&p->log, p->path);
    assert_non_null(file);
    static const char piece[4096];
    for (int i = 0; i < 1000; i++)
        file_write(file, piece, sizeof piece);
    bool done = file_commit(file);
    setrlimit(RLIMIT_FSIZE, &before);
    assert_false(done);
    assert_non_null(strstr(p->log.error, p->path));
    assert_non_null(strstr(p->log.error, strerror(EFBIG)));
    assert_int_equal(sample_count(p->folder), 0);
    assert_int_equal(p->log.nentries, 0);
}

static void missing_folder_is_named(void **state)
{
    struct place *p = *state;
    char path[PATH_MAX + 32], wanted[PATH_MAX + 64];
    snprintf(path, sizeof path, "%s/none/x.txt", p->folder);
    snprintf(wanted, sizeof wanted, "there is no folder '%s/none'", p->folder);
    assert_null(file_create(&p->log, path));
    assert_non_null(strstr(p->log.error, wanted));
    assert_false(file_check(&p->log, path));
}

static void folders_and_files_under_files_are_refused(void **state)
{
    struct place *p = *state;
    char under[sizeof p->path + 16];
    assert_true(write_text(p, "old"));
    snprintf(under, sizeof under, "%s/x.json", p->path);
    assert_false(file_check(&p->log, under));
    assert_false(file_check(&p->log, p->folder));
    assert_false(file_check(&p->log, ""));
    if (access("/proc/self", F_OK) == 0)    /* where not even root makes files */
        assert_false(file_check(&p->log, "/proc/x.txt"));
    assert_text(p->path, "old");
}

static void check_leaves_nothing(void **state)
{
    struct place *p = *state;
    assert_true(file_check(&p->log, p->path));
    assert_int_equal(sample_count(p->folder), 0);
    assert_null(p->log.error);
}

static void full_device_is_an_error(void **state)
{
    struct place *p = *state;
    if (access("/dev/full", W_OK) != 0)
        skip();
    struct file *file = file_create(&p->log, "/dev/full");
    assert_non_null(file);
    file_print(file, "text");
    assert_false(file_commit(file));
    assert_non_null(strstr(p->log.error, strerror(ENOSPC)));
}

static void device_is_written_directly(void **state)
{
    struct place *p = *state;
    struct file *file = file_create(&p->log, "/dev/null");
    file_print(file, "text");
    assert_true(file_commit(file));
    struct stat status;
    assert_int_equal(stat("/dev/null", &status), 0);
    assert_true(S_ISCHR(status.st_mode));
}

static void link_is_followed(void **state)
{
    struct place *p = *state;
    char link_path[PATH_MAX + 16];
    snprintf(link_path, sizeof link_path, "%s/link", p->folder);
    assert_true(write_text(p, "old"));
    assert_int_equal(symlink("x", link_path), 0);
    struct file *file = file_create(&p->log, link_path);
    file_print(file, "new");
    assert_true(file_commit(file));
    assert_text(p->path, "new");
    struct stat status;
    assert_int_equal(lstat(link_path, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
}

static void new_file_follows_the_umask(void **state)
{
    struct place *p = *state;
    mode_t before = umask(027);
    assert_true(write_text(p, "abc"));
    umask(before);
    struct stat status;
    assert_int_equal(stat(p->path, &status), 0);
    assert_int_equal(status.st_mode & 0777, 0640);
}

/* Killed in the middle: the handler's one call clears the folder. */
static void killed_writer_leaves_nothing(void **state)
{
    struct place *p = *state;
    pid_t child = fork();
    if (child == 0) {
        for (int i = 0; i < 3; i++)
            if (!file_create(&p->log, p->path))
                _exit(1);
        file_remove_unfinished();
        _exit(0);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    assert_int_equal(sample_count(p->folder), 0);
}

static void first_error_is_kept(void **state)
{
    struct place *p = *state;
    file_fail(&p->log, "first %d", 1);
    file_fail(&p->log, "second");
    assert_string_equal(p->log.error, "first 1");
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, sample_begin, sample_end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(committed_file_is_there_and_hashed),
        TEST(file_appears_at_commit_only),
        TEST(abandoned_file_leaves_the_old_one),
        TEST(long_file_arrives_whole),
        TEST(full_disk_leaves_nothing),
        TEST(missing_folder_is_named),
        TEST(folders_and_files_under_files_are_refused),
        TEST(check_leaves_nothing),
        TEST(full_device_is_an_error),
        TEST(device_is_written_directly),
        TEST(link_is_followed),
        TEST(new_file_follows_the_umask),
        TEST(killed_writer_leaves_nothing),
        TEST(first_error_is_kept),
    };
    return cmocka_run_group_tests_name("file", tests, NULL, NULL);
}

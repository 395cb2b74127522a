/* SPDX-License-Identifier: GPL-3.0-or-later
 * Output files that appear under their name only when they are complete:
 * bytes in, a renamed file and its SHA-256 out. */
#include <config.h>

#include "output/file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <sha2.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { BUFFER_SIZE = 1 << 16, PRINT_SIZE = 1000, UNFINISHED_MAX = 8 };

struct file {
    struct file_log *log;
    char            *path;      /* as asked for; NULL: standard output */
    char            *place;     /* where that is: another one for a log that has a folder */
    char            *target;    /* where it will stand, links followed; NULL: written directly */
    const char      *temporary; /* its name until then: a slot of unfinished */
    int              fd;        /* -1: goes nowhere */
    int              error;     /* errno of the first failure, or 0 */
    SHA2_CTX         hash;
    size_t           used;
    char             buffer[BUFFER_SIZE];
};

/* Names of the files being written, for the one who must remove them when the
 * program is killed: a signal handler can reach nothing else.  Empty = free. */
static char unfinished[UNFINISHED_MAX][PATH_MAX];

void file_remove_unfinished(void)
{
    for (int i = 0; i < UNFINISHED_MAX; i++)
        if (unfinished[i][0])
            unlink(unfinished[i]);
}

/* ---- the log ---- */

void file_fail(struct file_log *log, const char *format, ...)
{
    if (log->error)
        return;
    va_list arguments;
    va_start(arguments, format);
    if (vasprintf(&log->error, format, arguments) < 0)
        log->error = NULL;
    va_end(arguments);
}

void file_log_free(struct file_log *log)
{
    for (int i = 0; i < log->nentries; i++)
        free(log->entry[i].path);
    free(log->entry);
    free(log->error);
    *log = (struct file_log){0};
}

struct file_entry *file_log_find(const struct file_log *log, const char *path)
{
    for (int i = 0; i < log->nentries; i++)
        if (strcmp(log->entry[i].path, path) == 0)
            return &log->entry[i];
    return NULL;
}

/* The entry of a path, new where there is none; NULL when out of memory. */
static struct file_entry *log_entry(struct file_log *log, const char *path)
{
    struct file_entry *entry = file_log_find(log, path);
    if (entry)
        return entry;
    entry = realloc(log->entry, (size_t)(log->nentries + 1) * sizeof *entry);
    if (!entry)
        return NULL;
    log->entry = entry;
    entry += log->nentries;
    *entry = (struct file_entry){.path = strdup(path)};
    if (!entry->path)
        return NULL;
    log->nentries++;
    return entry;
}

/* ---- creation ---- */

bool file_is_unfinished(const char *name)
{
    size_t n = strlen(name);
    return strncmp(name, ".weft-", 6) == 0 && n > 11 && strcmp(name + n - 5, ".part") == 0;
}

bool file_is_plain(const char *path)
{
    struct stat status;
    return stat(path, &status) != 0 || S_ISREG(status.st_mode);
}

bool file_make_folder(const char *path)
{
    struct stat status;
    if (mkdir(path, 0777) == 0)
        return true;
    if (errno != EEXIST || stat(path, &status) != 0)
        return false;
    errno = ENOTDIR;
    return S_ISDIR(status.st_mode);
}

/* Adds a component to a place and makes the folder that stood there. */
static void descend(char *place, const char *component, size_t length)
{
    size_t n = strlen(place);
    mkdir(place, 0777);         /* what is wrong shows when the file is opened */
    snprintf(place + n, length + 4, "/%.*s", (int)length, component);
    if (strcmp(place + n, "/..") == 0)
        memcpy(place + n, "/up", 3);
}

/* Where a path is for this log; in its folder nothing leads out of it.  NULL: out of memory. */
static char *place_of(const struct file_log *log, const char *path)
{
    if (!log->into)
        return strdup(path);
    char *place = malloc(strlen(log->into) + 2 * strlen(path) + 8);
    if (!place)
        return NULL;
    strcpy(place, log->into);
    for (size_t length; *path; path += length) {
        path += strspn(path, "/");
        length = strcspn(path, "/");
        if (length > 0 && !(length == 1 && *path == '.'))
            descend(place, path, length);
    }
    return place;
}

static struct file *file_new(struct file_log *log, const char *path)
{
    struct file *file = malloc(sizeof *file);
    char *copy = path ? strdup(path) : NULL, *place = path ? place_of(log, path) : NULL;
    if (!file || (path && (!copy || !place))) {
        free(file);
        free(copy);
        free(place);
        file_fail(log, "out of memory");
        return NULL;
    }
    file->log = log;
    file->path = copy;
    file->place = place;
    file->target = NULL;
    file->temporary = NULL;
    file->fd = -1;
    file->error = 0;
    file->used = 0;
    SHA256Init(&file->hash);
    return file;
}

static void file_free(struct file *file)
{
    free(file->path);
    free(file->place);
    free(file->target);
    free(file);
}

/* Frees the slot of the temporary name. */
static void forget(struct file *file)
{
    if (file->temporary)
        unfinished[(file->temporary - unfinished[0]) / PATH_MAX][0] = '\0';
    file->temporary = NULL;
}

/* Opens a new file in the target's folder and notes its name among the
 * unfinished; -1 and errno if that cannot be. */
static int open_beside(struct file *file)
{
    const char *slash = strrchr(file->target, '/');
    int folder = slash ? (int)(slash - file->target) + 1 : 0;
    int slot = 0;
    while (slot < UNFINISHED_MAX && unfinished[slot][0])
        slot++;
    if (slot == UNFINISHED_MAX) {
        errno = EMFILE;
        return -1;
    }
    file->temporary = unfinished[slot];
    for (int i = 0; i < 10000; i++) {
        int length = snprintf(unfinished[slot], PATH_MAX, "%.*s.weft-%ld-%d.part", folder, file->target, (long)getpid(), i);
        if (length >= PATH_MAX) {
            errno = ENAMETOOLONG;
            break;
        }
        int fd = open(file->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0)
            return fd;
        if (errno != EEXIST)
            break;
    }
    forget(file);
    return -1;
}

/* Opens what stands for the path: the thing itself if it is a device or a
 * pipe, else a new file beside it. */
static bool file_open(struct file *file)
{
    struct stat status;
    bool exists = stat(file->place, &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) {
        errno = EISDIR;
        return false;
    }
    if (exists && !S_ISREG(status.st_mode)) {
        file->fd = open(file->place, O_WRONLY | O_CLOEXEC);
        return file->fd >= 0;
    }
    if (exists && access(file->place, W_OK) != 0)
        return false;
    file->target = exists ? realpath(file->place, NULL) : strdup(file->place);
    if (!file->target)
        return false;
    file->fd = open_beside(file);
    if (exists && file->fd >= 0 && fchmod(file->fd, status.st_mode & 0777) != 0)
        return false;
    return file->fd >= 0;
}

/* Says why a path cannot be opened. */
static void explain(struct file_log *log, const char *path, int error)
{
    const char *slash = strrchr(path, '/');
    if (error == ENOENT && slash)
        file_fail(log, "cannot write '%s': there is no folder '%.*s'", path, (int)(slash - path), path);
    else
        file_fail(log, "cannot write '%s': %s", path, strerror(error));
}

struct file *file_create(struct file_log *log, const char *path)
{
    struct file *file = file_new(log, path);
    if (!file)
        return NULL;
    if (!*path)
        errno = ENOENT;
    if (*path && file_open(file))
        return file;
    explain(log, path, errno);
    file_free(file);
    return NULL;
}

struct file *file_stdout(struct file_log *log)
{
    struct file *file = file_new(log, NULL);
    if (file)
        file->fd = STDOUT_FILENO;
    return file;
}

struct file *file_hasher(struct file_log *log)
{
    return file_new(log, NULL);
}

/* ---- writing ---- */

/* Hashes and writes what is buffered. */
static void flush(struct file *file)
{
    SHA256Update(&file->hash, (const uint8_t *)file->buffer, file->used);
    for (size_t done = 0; file->fd >= 0 && done < file->used && !file->error;) {
        ssize_t n = write(file->fd, file->buffer + done, file->used - done);
        if (n >= 0)
            done += (size_t)n;
        else if (errno != EINTR)
            file->error = errno;
    }
    file->used = 0;
}

void file_write(struct file *file, const void *data, size_t size)
{
    const char *from = data;
    while (size > 0 && !file->error) {
        size_t room = BUFFER_SIZE - file->used;
        size_t n = size < room ? size : room;
        memcpy(file->buffer + file->used, from, n);
        file->used += n;
        from += n;
        size -= n;
        if (file->used == BUFFER_SIZE)
            flush(file);
    }
}

void file_print(struct file *file, const char *format, ...)
{
    char text[PRINT_SIZE + 1];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (length < 0 || length > PRINT_SIZE)
        file->error = file->error ? file->error : EOVERFLOW;
    else
        file_write(file, text, (size_t)length);
}

/* ---- the end ---- */

void file_abandon(struct file *file)
{
    if (file->path && file->fd >= 0)
        close(file->fd);
    if (file->temporary)
        unlink(file->temporary);
    forget(file);
    file_free(file);
}

static void hash_text(SHA2_CTX *context, char sha256[FILE_HASH])
{
    uint8_t digest[SHA256_DIGEST_LENGTH];
    SHA256Final(digest, context);
    for (size_t i = 0; i < sizeof digest; i++)
        snprintf(sha256 + 2 * i, 3, "%02x", digest[i]);
}

bool file_commit(struct file *file)
{
    flush(file);
    if (file->path && close(file->fd) != 0 && !file->error)
        file->error = errno;
    file->fd = -1;
    if (!file->error && file->temporary) {
        if (rename(file->temporary, file->target) == 0)
            forget(file);
        else
            file->error = errno;
    }
    struct file_entry *entry = !file->error && file->path ? log_entry(file->log, file->path) : NULL;
    if (!file->error && file->path && !entry)
        file->error = ENOMEM;
    bool done = !file->error;
    if (entry)
        hash_text(&file->hash, entry->sha256);
    if (!done && file->path)
        file_fail(file->log, "cannot write '%s': %s", file->path, strerror(file->error));
    else if (!done && file->error != EPIPE)      /* the reader has had enough: no news to anyone */
        file_fail(file->log, "cannot write to standard output: %s", strerror(file->error));
    file_abandon(file);
    return done;
}

bool file_check(struct file_log *log, const char *path)
{
    struct stat status;
    if (!log->into && stat(path, &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
        if (access(path, W_OK) == 0)
            return true;
        explain(log, path, errno);
        return false;
    }
    struct file *file = file_create(log, path);
    if (file)
        file_abandon(file);
    return file;
}

void file_hash(struct file *hasher, char sha256[FILE_HASH])
{
    flush(hasher);
    hash_text(&hasher->hash, sha256);
    file_free(hasher);
}

void file_hash_text(struct file_log *log, const void *text, size_t size, char sha256[FILE_HASH])
{
    struct file *hasher = file_hasher(log);
    sha256[0] = '\0';
    if (!hasher)
        return;
    file_write(hasher, text, size);
    file_hash(hasher, sha256);
}

bool file_hash_path(const char *path, char sha256[FILE_HASH])
{
    struct file_log log = {0};
    FILE *stream = fopen(path, "rb");
    struct file *hasher = stream ? file_hasher(&log) : NULL;
    char buffer[1 << 15];
    for (size_t n; hasher && (n = fread(buffer, 1, sizeof buffer, stream)) > 0;)
        file_write(hasher, buffer, n);
    bool read = hasher && !ferror(stream);
    if (hasher)
        file_hash(hasher, sha256);
    if (stream)
        fclose(stream);
    file_log_free(&log);
    return read;
}

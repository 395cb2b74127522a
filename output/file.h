/* SPDX-License-Identifier: GPL-3.0-or-later
 * Output files that appear under their name only when they are complete:
 * bytes in, a renamed file and its SHA-256 out.  A file is written beside its
 * final place under a temporary name; file_commit renames it.  Until then, and
 * after any error, whatever stood under the final name stands there still. */
#ifndef WEFT_FILE_H
#define WEFT_FILE_H

#include <stdbool.h>
#include <stddef.h>

enum { FILE_HASH = 65 };        /* 64 hexadecimal digits and the end */

/* A file that was committed. */
struct file_entry {
    char *path;                 /* as asked for */
    char  sha256[FILE_HASH];
    char  lasting[FILE_HASH];   /* of what does not differ from run to run; empty: all */
};

/* What a run has written, and what went wrong first.  Start with all zero. */
struct file_log {
    const char        *into;    /* a folder that all paths are taken to be in, with folders made as needed; NULL: as they are */
    int                nentries;
    struct file_entry *entry;   /* (nentries), in order of first commit; a file written again keeps its place */
    char              *error;   /* a sentence naming the file, or NULL */
};

struct file;

/* Begins a file.  NULL, with log->error set, if the folder is missing or not
 * writable, or path is a folder.  A symbolic link is followed; a file that is
 * replaced passes its rights on; a device or a pipe is written to directly. */
struct file *file_create(struct file_log *log, const char *path);

/* Standard output as a file: file_commit flushes it, nothing is logged but
 * errors, and not that a pipe's reader went away. */
struct file *file_stdout(struct file_log *log);

/* A file that goes nowhere, to be hashed; ends with file_hash. */
struct file *file_hasher(struct file_log *log);

/* Adds bytes.  An error is kept for file_commit; later bytes are dropped. */
void file_write(struct file *file, const void *data, size_t size);

/* Adds text in the C locale's format, at most 1000 bytes a call. */
void file_print(struct file *file, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Closes the file under its final name, or removes it and sets log->error. */
bool file_commit(struct file *file);

/* Closes the file and removes it. */
void file_abandon(struct file *file);

/* Could path be written?  If not, false and log->error; nothing stays behind. */
bool file_check(struct file_log *log, const char *path);

/* Makes a folder unless it is there; false: errno. */
bool file_make_folder(const char *path);

/* A plain file or a new name: not a device, a pipe or a folder. */
bool file_is_plain(const char *path);

/* Is this the name, without its folder, of a file that was not finished? */
bool file_is_unfinished(const char *name);

/* Removes all unfinished files.  For signal handlers: calls unlink alone. */
void file_remove_unfinished(void);

/* Sets log->error, unless an earlier one stands there. */
void file_fail(struct file_log *log, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The entry of a path that was committed, or NULL. */
struct file_entry *file_log_find(const struct file_log *log, const char *path);

void file_log_free(struct file_log *log);

/* Ends a hasher: SHA-256 of its bytes, as hexadecimal digits. */
void file_hash(struct file *hasher, char sha256[FILE_HASH]);

/* SHA-256 of a file that is there; false, and errno: it cannot be read. */
bool file_hash_path(const char *path, char sha256[FILE_HASH]);

/* SHA-256 of a text. */
void file_hash_text(struct file_log *log, const void *text, size_t size, char sha256[FILE_HASH]);

#endif

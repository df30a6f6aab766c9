// SPDX-License-Identifier: BSD-3-Clause
//
// Makes file calls of a program fail: LD_PRELOAD=fault_injector.so, and in the environment
//
//   FAULT_PREFIX  only files whose absolute path begins with this are looked at
//   FAULT_LOG     file to which each call is appended, "write 3 /path": its name, its number among
//                 calls of that name (from 1), its file; must not lie under the prefix
//   FAULT_CALL    what fails: open write pwrite read pread fsync ftruncate close rename unlink
//   mkdir
//                 flock (all variants of a call are one)
//   FAULT_AT      the number of the first call that fails; absent: none
//   FAULT_TIMES   how many fail from there on, or "always" [1]
//   FAULT_ERROR   EIO ENOSPC EDQUOT EACCES EINTR ENOLCK ENOTSUP, a number, or
//                 KILL: the process is killed instead; HALF: half of what is to be written is, and
//                 the call says so; LOST: nothing is written, and the call says it was [EIO]
//
// A close that fails has closed the file, as Linux has it. What libc does within itself (fopen,
// fprintf) does not pass here.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { LOST = -1, HALF = -2, KILL = -3, NONE = 0 };

enum call {
  OPEN,
  WRITE,
  PWRITE,
  READ,
  PREAD,
  FSYNC,
  FTRUNCATE,
  CLOSE,
  RENAME,
  UNLINK,
  MKDIR,
  FLOCK
};
static char const* const names[] = {"open",      "write", "pwrite", "read",   "pread", "fsync",
                                    "ftruncate", "close", "rename", "unlink", "mkdir", "flock"};
static atomic_long counts[sizeof names / sizeof *names];

static int number_of_error(char const* name) {
  static struct {
    char const* name;
    int number;
  } const known[] = {{"EIO", EIO},     {"ENOSPC", ENOSPC}, {"EDQUOT", EDQUOT},   {"EACCES", EACCES},
                     {"EINTR", EINTR}, {"ENOLCK", ENOLCK}, {"ENOTSUP", ENOTSUP}, {"KILL", KILL},
                     {"HALF", HALF},   {"LOST", LOST}};
  for (size_t k = 0; name && k < sizeof known / sizeof *known; ++k)
    if (strcmp(name, known[k].name) == 0) return known[k].number;
  if (name && *name >= '1' && *name <= '9') return atoi(name);
  return EIO;
}

static void append_to_log(char const* log, enum call call, long number, char const* path) {
  char line[PATH_MAX + 64];
  int const length = snprintf(line, sizeof line, "%s %ld %s\n", names[call], number, path);
  int const file = (int)syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (syscall(SYS_write, file, line, (size_t)length) != length) abort();
  syscall(SYS_close, file);
}

/// What becomes of a call on an absolute path: NONE, an errno, HALF or LOST.
static int fault(enum call call, char const* path) {
  char const* const prefix = getenv("FAULT_PREFIX");
  if (!prefix || strncmp(path, prefix, strlen(prefix)) != 0) return NONE;
  long const number = atomic_fetch_add(&counts[call], 1) + 1;
  char const* const log = getenv("FAULT_LOG");
  if (log) append_to_log(log, call, number, path);
  char const* const wanted = getenv("FAULT_CALL");
  char const* const at = getenv("FAULT_AT");
  char const* const times = getenv("FAULT_TIMES");
  if (!wanted || !at || strcmp(wanted, names[call]) != 0) return NONE;
  long const first = atol(at);
  long const many = !times ? 1 : strcmp(times, "always") == 0 ? LONG_MAX - first : atol(times);
  if (number < first || number >= first + many) return NONE;
  int const error = number_of_error(getenv("FAULT_ERROR"));
  if (error == KILL) kill(getpid(), SIGKILL);
  return error;
}

static int fault_at_path(enum call call, int folder, char const* path) {
  char whole[2 * PATH_MAX] = "";
  if (path[0] != '/') {
    char link[64];
    snprintf(link, sizeof link, folder == AT_FDCWD ? "/proc/self/cwd" : "/proc/self/fd/%d", folder);
    ssize_t const length = readlink(link, whole, PATH_MAX - 1);
    whole[length < 0 ? 0 : length] = '\0';
    strcat(whole, "/");
  }
  strncat(whole, path, PATH_MAX - 1);
  return fault(call, whole);
}

static int fault_of_file(enum call call, int file) {
  char link[64], path[PATH_MAX];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  int const before = errno;
  ssize_t const length = readlink(link, path, sizeof path - 1);
  errno = before;
  if (length < 0) return NONE;
  path[length] = '\0';
  return fault(call, path);
}

#define REAL(type, name, ...) ((type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, #name))
#define FAIL_IF(error)   \
  do {                   \
    int const e = error; \
    if (e > 0) {         \
      errno = e;         \
      return -1;         \
    }                    \
  } while (0)

static mode_t mode_of(int flags, va_list more) {
  return flags & (O_CREAT | __O_TMPFILE) ? va_arg(more, mode_t) : 0;
}

#define OPEN_LIKE(name)                                               \
  int name(char const* path, int flags, ...) {                        \
    va_list more;                                                     \
    va_start(more, flags);                                            \
    mode_t const mode = mode_of(flags, more);                         \
    va_end(more);                                                     \
    FAIL_IF(fault_at_path(OPEN, AT_FDCWD, path));                     \
    return REAL(int, name, char const*, int, ...)(path, flags, mode); \
  }
OPEN_LIKE(open)
OPEN_LIKE(open64)

#define OPENAT_LIKE(name)                                                          \
  int name(int folder, char const* path, int flags, ...) {                         \
    va_list more;                                                                  \
    va_start(more, flags);                                                         \
    mode_t const mode = mode_of(flags, more);                                      \
    va_end(more);                                                                  \
    FAIL_IF(fault_at_path(OPEN, folder, path));                                    \
    return REAL(int, name, int, char const*, int, ...)(folder, path, flags, mode); \
  }
OPENAT_LIKE(openat)
OPENAT_LIKE(openat64)

ssize_t write(int file, void const* bytes, size_t size) {
  int const what = fault_of_file(WRITE, file);
  FAIL_IF(what);
  if (what == LOST) return (ssize_t)size;
  return REAL(ssize_t, write, int, void const*, size_t)(file, bytes,
                                                        what == HALF ? (size + 1) / 2 : size);
}

#define PWRITE_LIKE(name, offset_type)                                         \
  ssize_t name(int file, void const* bytes, size_t size, offset_type offset) { \
    int const what = fault_of_file(PWRITE, file);                              \
    FAIL_IF(what);                                                             \
    if (what == LOST) return (ssize_t)size;                                    \
    return REAL(ssize_t, name, int, void const*, size_t, offset_type)(         \
        file, bytes, what == HALF ? (size + 1) / 2 : size, offset);            \
  }
PWRITE_LIKE(pwrite, off_t)
PWRITE_LIKE(pwrite64, off64_t)

ssize_t read(int file, void* bytes, size_t size) {
  FAIL_IF(fault_of_file(READ, file));
  return REAL(ssize_t, read, int, void*, size_t)(file, bytes, size);
}

#define PREAD_LIKE(name, offset_type)                                                       \
  ssize_t name(int file, void* bytes, size_t size, offset_type offset) {                    \
    FAIL_IF(fault_of_file(PREAD, file));                                                    \
    return REAL(ssize_t, name, int, void*, size_t, offset_type)(file, bytes, size, offset); \
  }
PREAD_LIKE(pread, off_t)
PREAD_LIKE(pread64, off64_t)

#define SYNC_LIKE(name)                  \
  int name(int file) {                   \
    FAIL_IF(fault_of_file(FSYNC, file)); \
    return REAL(int, name, int)(file);   \
  }
SYNC_LIKE(fsync)
SYNC_LIKE(fdatasync)

#define FTRUNCATE_LIKE(name, offset_type)                 \
  int name(int file, offset_type size) {                  \
    FAIL_IF(fault_of_file(FTRUNCATE, file));              \
    return REAL(int, name, int, offset_type)(file, size); \
  }
FTRUNCATE_LIKE(ftruncate, off_t)
FTRUNCATE_LIKE(ftruncate64, off64_t)

int close(int file) {
  int const what = fault_of_file(CLOSE, file);
  int const result = REAL(int, close, int)(file);
  FAIL_IF(what);
  return result;
}

int rename(char const* from, char const* to) {
  FAIL_IF(fault_at_path(RENAME, AT_FDCWD, to));
  return REAL(int, rename, char const*, char const*)(from, to);
}

int unlink(char const* path) {
  FAIL_IF(fault_at_path(UNLINK, AT_FDCWD, path));
  return REAL(int, unlink, char const*)(path);
}

int remove(char const* path) {
  FAIL_IF(fault_at_path(UNLINK, AT_FDCWD, path));
  return REAL(int, remove, char const*)(path);
}

int unlinkat(int folder, char const* path, int flags) {
  FAIL_IF(fault_at_path(UNLINK, folder, path));
  return REAL(int, unlinkat, int, char const*, int)(folder, path, flags);
}

int mkdir(char const* path, mode_t mode) {
  FAIL_IF(fault_at_path(MKDIR, AT_FDCWD, path));
  return REAL(int, mkdir, char const*, mode_t)(path, mode);
}

int flock(int file, int operation) {
  FAIL_IF(fault_of_file(FLOCK, file));
  return REAL(int, flock, int, int)(file, operation);
}

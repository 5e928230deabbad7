// Preloaded: a disk that refuses what changes a folder, from one call on; see `refuse_writes`.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static char folder[PATH_MAX];
static atomic_int left = -1;  // calls that are allowed before the first refusal; below 0: all
static atomic_int refused = 0;
static int number = 0;  // of the error

// From now on, refuse all calls that create, write, close, rename or remove something below `path`, with the error
// `error`, but for the first `allowed` ones. An empty path ends this. A refused `close` closes, as that of a real disk does.
void refuse_writes(const char* path, int allowed, int error) {
  snprintf(folder, sizeof folder, "%s", path);
  number = error;
  atomic_store(&refused, 0);
  atomic_store(&left, *path ? allowed : -1);
}

int refused_writes(void) { return atomic_load(&refused); }

static int is_below(const char* path) {
  return *folder && path != NULL && strncmp(path, folder, strlen(folder)) == 0;
}

static int is_open_below(int descriptor) {
  char link[64], path[PATH_MAX];
  if (!*folder) return 0;
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t size = readlink(link, path, sizeof path - 1);
  if (size <= 0) return 0;
  path[size] = 0;
  if (!is_below(path)) return 0;
  const int flags = fcntl(descriptor, F_GETFL);
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

static int is_refused(int concerns_folder) {
  if (!concerns_folder || atomic_load(&left) < 0) return 0;
  if (atomic_load(&left) > 0) {
    atomic_fetch_sub(&left, 1);
    return 0;
  }
  atomic_fetch_add(&refused, 1);
  errno = number;
  return 1;
}

#define NEXT(result, name, ...) ((result(*)(__VA_ARGS__))dlsym(RTLD_NEXT, #name))

static int writes(int flags) { return (flags & O_ACCMODE) != O_RDONLY || (flags & O_CREAT) != 0; }

#define OPEN(name)                                                        \
  int name(const char* path, int flags, ...) {                            \
    va_list rest;                                                         \
    va_start(rest, flags);                                                \
    const mode_t mode = va_arg(rest, mode_t);                             \
    va_end(rest);                                                         \
    if (is_refused(writes(flags) && is_below(path))) return -1;           \
    return NEXT(int, name, const char*, int, ...)(path, flags, mode);     \
  }
OPEN(open)
OPEN(open64)

ssize_t write(int descriptor, const void* data, size_t size) {
  if (is_refused(is_open_below(descriptor))) return -1;
  return NEXT(ssize_t, write, int, const void*, size_t)(descriptor, data, size);
}

int fsync(int descriptor) {
  if (is_refused(is_open_below(descriptor))) return -1;
  return NEXT(int, fsync, int)(descriptor);
}

int close(int descriptor) {
  const int is_failing = is_refused(is_open_below(descriptor));
  const int result = NEXT(int, close, int)(descriptor);
  if (is_failing) errno = number;
  return is_failing ? -1 : result;
}

int mkdir(const char* path, mode_t mode) {
  if (is_refused(is_below(path))) return -1;
  return NEXT(int, mkdir, const char*, mode_t)(path, mode);
}

int rename(const char* from, const char* to) {
  if (is_refused(is_below(to))) return -1;
  return NEXT(int, rename, const char*, const char*)(from, to);
}

int symlink(const char* target, const char* path) {
  if (is_refused(is_below(path))) return -1;
  return NEXT(int, symlink, const char*, const char*)(target, path);
}

int chmod(const char* path, mode_t mode) {
  if (is_refused(is_below(path))) return -1;
  return NEXT(int, chmod, const char*, mode_t)(path, mode);
}

int unlink(const char* path) {
  if (is_refused(is_below(path))) return -1;
  return NEXT(int, unlink, const char*)(path);
}

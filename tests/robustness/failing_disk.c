// A library to preload: lets writing to chosen files fail, as a broken or full disk would. Controlled by the environment:
//   FAULT_FILE   what the path of the opened file must contain
//   FAULT_RANK   the rank of Open MPI on which the disk fails; all when missing
//   FAULT_AFTER  how many writes succeed before all further ones fail
//   FAULT_ERRNO  the number of the error, 28 (ENOSPC) when missing
// Writes of the C library's own streams do not pass here.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/uio.h>
#include <unistd.h>

static int chosen_rank(void) {
  const char* wanted = getenv("FAULT_RANK");
  const char* mine = getenv("OMPI_COMM_WORLD_RANK");
  return wanted == NULL || mine == NULL || strcmp(wanted, mine) == 0;
}

static int chosen_file(int descriptor) {
  const char* wanted = getenv("FAULT_FILE");
  if (wanted == NULL) return 0;
  char link[64];
  char path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = '\0';
  return strstr(path, wanted) != NULL;
}

/// Counts a write; nonzero when it must fail, with errno set.
static int fails(int descriptor) {
  static long written = 0;
  if (!chosen_rank() || !chosen_file(descriptor)) return 0;
  const char* after = getenv("FAULT_AFTER");
  if (written++ < (after == NULL ? 0 : atol(after))) return 0;
  const char* code = getenv("FAULT_ERRNO");
  errno = code == NULL ? ENOSPC : atoi(code);
  return 1;
}

/// The function of this name that would have been called without this library.
#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

ssize_t write(int fd, const void* bytes, size_t count) { return fails(fd) ? -1 : NEXT(write)(fd, bytes, count); }

ssize_t writev(int fd, const struct iovec* parts, int count) {
  return fails(fd) ? -1 : NEXT(writev)(fd, parts, count);
}

ssize_t pwrite(int fd, const void* bytes, size_t count, off_t at) {
  return fails(fd) ? -1 : NEXT(pwrite)(fd, bytes, count, at);
}

ssize_t pwrite64(int fd, const void* bytes, size_t count, off64_t at) {
  return fails(fd) ? -1 : NEXT(pwrite64)(fd, bytes, count, at);
}

ssize_t pwritev(int fd, const struct iovec* parts, int count, off_t at) {
  return fails(fd) ? -1 : NEXT(pwritev)(fd, parts, count, at);
}

ssize_t pwritev64(int fd, const struct iovec* parts, int count, off64_t at) {
  return fails(fd) ? -1 : NEXT(pwritev64)(fd, parts, count, at);
}

int fsync(int fd) { return fails(fd) ? -1 : NEXT(fsync)(fd); }

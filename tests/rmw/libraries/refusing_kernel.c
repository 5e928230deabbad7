// Preloaded: a kernel that refuses to bind a socket to an interface, as Linux before 5.7 does for a user.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <sys/socket.h>

int setsockopt(int socket, int level, int option, const void* value, socklen_t size) {
  if (level == SOL_SOCKET && option == SO_BINDTODEVICE) {
    errno = EPERM;
    return -1;
  }
  return ((int (*)(int, int, int, const void*, socklen_t))dlsym(RTLD_NEXT, "setsockopt"))(socket, level, option, value,
                                                                                          size);
}

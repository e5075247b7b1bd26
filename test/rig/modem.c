/*
 * Firefox asks a serial port for its modem lines when it opens it, and a pty has none: this answers for it. Everything
 * else goes to the kernel. `cc -shared -fPIC`, and LD_PRELOAD in Firefox.
 */
#define _GNU_SOURCE
#include <stdarg.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

int ioctl(int fd, unsigned long request, ...) {
  va_list more;
  va_start(more, request);
  void *argument = va_arg(more, void *);
  va_end(more);
  if (request != TIOCMGET || !isatty(fd)) return syscall(SYS_ioctl, fd, request, argument);
  *(int *)argument = TIOCM_DTR | TIOCM_RTS;
  return 0;
}

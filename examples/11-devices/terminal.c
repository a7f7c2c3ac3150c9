#define _DEFAULT_SOURCE
#define _XOPEN_SOURCE 600

#include "terminal.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

enum { LEASE_MS = 2000 };

static int is_for_later(void) { return errno == EAGAIN || errno == EINTR; }

static int make_line(terminal *line) {
  struct termios settings;
  memset(line, 0, sizeof *line);
  line->file = posix_openpt(O_RDWR | O_NOCTTY);
  if (line->file < 0 || grantpt(line->file) != 0 || unlockpt(line->file) != 0) return 0;
  /* Held open, so that the line stays when the door goes. */
  if (open(ptsname(line->file), O_RDWR | O_NOCTTY) < 0 || tcgetattr(line->file, &settings) != 0) return 0;
  cfmakeraw(&settings);
  if (tcsetattr(line->file, TCSANOW, &settings) != 0 || fcntl(line->file, F_SETFL, O_NONBLOCK) != 0) return 0;
  printf("at %s\n", ptsname(line->file));
  return fflush(stdout) == 0;
}

static int open_line(void *line) { return ((terminal *)line)->file >= 0; }

static int send_line(void *line, const char *bytes, int count) {
  const ssize_t sent = write(((terminal *)line)->file, bytes, (size_t)count);
  if (sent < 0) return is_for_later() ? 0 : -1;
  return (int)sent;
}

static int receive_line(void *line, char *into, int room) {
  const ssize_t count = read(((terminal *)line)->file, into, (size_t)room);
  if (count < 0) return is_for_later() ? 0 : -1;
  return (int)count;
}

int terminal_begin(terminal *line, pizarra_device *device, const char *name,
                   void (*heard)(void *user, const pizarra_news *news), int count, char **words) {
  static pizarra_calls calls;
  if (count != 2 || !make_line(line)) {
    fprintf(stderr, "usage: %s TOKEN\n", words[0]);
    return 0;
  }
  calls.user = line;
  calls.open = open_line;
  calls.send = send_line;
  calls.receive = receive_line;
  calls.heard = heard;
  pizarra_begin(device, &calls, name, words[1], LEASE_MS);
  return 1;
}

int terminal_wait(terminal *line, int milliseconds) {
  struct pollfd files[2];
  char c;
  files[0].fd = line->file;
  files[1].fd = STDIN_FILENO;
  files[0].events = files[1].events = POLLIN;
  files[1].revents = 0;
  if (poll(files, 2, milliseconds) <= 0 || files[1].revents == 0) return 0;
  if (read(STDIN_FILENO, &c, 1) != 1) return -1;
  if (c == '\n') {
    line->typed[line->typed_size] = 0;
    line->typed_size = 0;
    return 1;
  }
  if (line->typed_size < (int)sizeof line->typed - 1) line->typed[line->typed_size++] = c;
  return 0;
}

uint32_t terminal_clock(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (uint32_t)now.tv_sec * 1000u + (uint32_t)(now.tv_nsec / 1000000);
}

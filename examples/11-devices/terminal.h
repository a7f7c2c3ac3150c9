#ifndef TERMINAL_H
#define TERMINAL_H

/* A device's end of a pseudo-terminal, which the text door opens like a serial line, and a line that somebody types. On
   a real device this file is its serial port. */

#include <stdint.h>

typedef struct {
  int file;
  char typed[32];
  int typed_size;
} terminal;

/* Makes it, and prints where its other end is. Not 0 where there is one. */
int terminal_begin(terminal *line);
/* Waits some milliseconds for what comes or is typed. Negative when nothing can be typed any more; not 0 when a line
   was typed, which stands in `typed`. */
int terminal_wait(terminal *line, int milliseconds);
uint32_t terminal_clock(void);

/* For pizarra_calls; the user is the terminal. */
int terminal_open(void *line);
int terminal_send(void *line, const char *bytes, int count);
int terminal_receive(void *line, char *into, int room);

#endif

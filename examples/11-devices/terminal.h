#ifndef TERMINAL_H
#define TERMINAL_H

/* A device's end of a pseudo-terminal, which the text door opens like a serial line, and a line that somebody types. On
   a real device this file is its serial port. */

#include <stdint.h>

#include "pizarra_device.h"

typedef struct {
  int file;
  char typed[32];
  int typed_size;
} terminal;

/* Makes the line, prints where its other end is, and begins the device there, whose token is the program's one word. Not
   0 where it could. */
int terminal_begin(terminal *line, pizarra_device *device, const char *name,
                   void (*heard)(void *user, const pizarra_news *news), int count, char **words);
/* Waits some milliseconds for what comes or is typed. Negative when nothing can be typed any more; not 0 when a line
   was typed, which stands in `typed`. */
int terminal_wait(terminal *line, int milliseconds);
uint32_t terminal_clock(void);

#endif

/* A light barrier: something in its beam is (blocked barrier-1), and while it works (watching barrier-1) stands. Emulated:
   type `block`, `free` or `end`.

     light_barrier TOKEN

   (watching barrier-1) is told under a lease, so that it goes when this device does. (blocked barrier-1) is not: what
   was seen last stands until this device says otherwise. */

#include <string.h>

#include "terminal.h"

enum { TRY_AGAIN_MS = 500 };

static pizarra_device device;
static terminal line;
static int in_beam;     /* what is seen */
static int to_tell;     /* it has changed, or the board may not know */
static int watching;    /* the requests that tell it, and that this device works */
static int telling;
static uint32_t failed; /* when it was refused last */

static void heard(void *user, const pizarra_news *news) {
  (void)user;
  if (news->kind == PIZARRA_JOINED) {
    pizarra_declare(&device, "(relation blocked ((barrier symbol))) (relation watching ((barrier symbol)))");
  } else if (news->kind == PIZARRA_LEASED) {
    to_tell = 1;
  } else if (news->kind == PIZARRA_FAIL && (news->number == telling || news->number == watching)) {
    to_tell = 1;
    failed = terminal_clock();
  } else if (news->kind == PIZARRA_GONE) {
    to_tell = 0;
  }
}

static void tell_beam(void) {
  int number;
  if (!to_tell || terminal_clock() - failed < TRY_AGAIN_MS) return;
  watching = pizarra_tell_leased(&device, "(watching barrier-1)");
  number = in_beam ? pizarra_tell(&device, "(blocked barrier-1)") : pizarra_retract(&device, "(blocked barrier-1)");
  if (number == 0) return;
  telling = number;
  to_tell = 0;
}

int main(int count, char **words) {
  int typed = 0;
  if (!terminal_begin(&line, &device, "barrier-1", heard, count, words)) return 2;
  while (typed >= 0) {
    pizarra_run(&device, terminal_clock());
    tell_beam();
    typed = terminal_wait(&line, 10);
    if (typed <= 0) continue;
    if (strcmp(line.typed, "end") == 0) break;
    in_beam = strcmp(line.typed, "block") == 0;
    to_tell = pizarra_joined(&device);
  }
  return 0;
}

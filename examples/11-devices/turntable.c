/* A turntable: it turns to where (turn-to table-1 DEGREES) says, 90 degrees a second, and tells where it has come to rest
   as (turned table-1 DEGREES). Emulated: it ends when `end` is typed.

     turntable TOKEN */

#include <string.h>

#include "terminal.h"

enum { TRY_AGAIN_MS = 500, MS_A_DEGREE = 11, WISHES = 1 };

static pizarra_device device;
static terminal line;
static int32_t at;
static int32_t wanted;
static int to_tell;
static int telling;
static uint32_t failed;
static uint32_t moved;

static void wish(pizarra_text fact) {
  int32_t degrees;
  if (pizarra_integer(pizarra_nth(pizarra_inside(fact), 2), &degrees) && degrees >= 0 && degrees < 360) {
    if (at == wanted) moved = terminal_clock();
    wanted = degrees;
    to_tell = 1;
  }
}

static void heard(void *user, const pizarra_news *news) {
  (void)user;
  if (news->kind == PIZARRA_JOINED) {
    pizarra_declare(&device,
                    "(relation turn-to ((table symbol) (degrees integer)) (key table)) "
                    "(relation turned ((table symbol) (degrees integer)) (key table))");
    pizarra_watch(&device, WISHES, "(turn-to table-1 ?degrees)");
  } else if (news->kind == PIZARRA_LEASED) {
    to_tell = 1;
  } else if (news->kind == PIZARRA_CAME && news->number == WISHES) {
    wish(pizarra_nth(news->text, 0));
  } else if (news->kind == PIZARRA_FAIL && news->number == telling) {
    to_tell = 1;
    failed = terminal_clock();
  }
}

static void turn(void) {
  const uint32_t now = terminal_clock();
  while (at != wanted && now - moved >= MS_A_DEGREE) {
    at += at < wanted ? 1 : -1;
    moved += MS_A_DEGREE;
  }
}

static void tell_rest(void) {
  char fact[40] = "(turned table-1 ";
  int number;
  if (!to_tell || at != wanted || terminal_clock() - failed < TRY_AGAIN_MS) return;
  pizarra_add_integer(fact, sizeof fact, at);
  pizarra_add(fact, sizeof fact, ")");
  number = pizarra_tell_leased(&device, fact);
  if (number == 0) return;
  telling = number;
  to_tell = 0;
}

int main(int count, char **words) {
  int typed = 0;
  if (!terminal_begin(&line, &device, "table-1", heard, count, words)) return 2;
  while (typed >= 0) {
    pizarra_run(&device, terminal_clock());
    turn();
    tell_rest();
    typed = terminal_wait(&line, 10);
    if (typed > 0 && strcmp(line.typed, "end") == 0) break;
  }
  return 0;
}

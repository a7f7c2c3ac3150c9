#ifndef PIZARRA_DEVICE_H
#define PIZARRA_DEVICE_H

/* A client of a Pizarra board for small devices, by the text door (docs/small-devices.md): C99, no heap, nothing of the
   C library but string.h. It never waits. Its memory is this one structure; how lines come and go is said by callbacks.

     static pizarra_device device;
     pizarra_begin(&device, &calls, "barrier-1", token, 2000);
     for (;;) {
       pizarra_run(&device, milliseconds());
       if (beam_changed) pizarra_tell_leased(&device, "(blocked barrier-1)");
     }

   It joins by itself, keeps its lease, and begins anew when the line was lost, when the door closed it, or when what
   came is not understood. What it told under its lease then goes, unless it is told again in time: tell it at every
   PIZARRA_LEASED, and watch at every PIZARRA_JOINED. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef PIZARRA_LINE
#define PIZARRA_LINE 256 /* of a line that comes, with its end; of a longer one only the beginning is heard */
#endif
#ifndef PIZARRA_QUEUE
#define PIZARRA_QUEUE 384 /* bytes that wait to go */
#endif
#ifndef PIZARRA_ASKED
#define PIZARRA_ASKED 8 /* requests that are not answered yet */
#endif

/* Part of a line, without an end of its own. Size 0: there is nothing. */
typedef struct {
  const char *at;
  int size;
} pizarra_text;

typedef enum {
  PIZARRA_JOINED, /* the session has begun: watch now */
  PIZARRA_LEASED, /* the lease is a new one, and nothing stands under it: tell now */
  PIZARRA_OK,     /* request `number` is done; text: the values of its answer */
  PIZARRA_FAIL,   /* request `number` is refused; text: a symbol and a sentence */
  PIZARRA_ANEW,   /* all that was heard of watch `number` is void */
  PIZARRA_CAME,   /* text: an answer of watch `number` that holds now */
  PIZARRA_WENT,   /* text: one that holds no more */
  PIZARRA_NOW,    /* that was one change of watch `number`, whole */
  PIZARRA_LOST,   /* watch `number` has ended; text: a symbol and a sentence */
  PIZARRA_GONE    /* the session has ended, and its requests are lost, or was refused; text: why, where that was said */
} pizarra_kind;

typedef struct {
  pizarra_kind kind;
  int number;
  pizarra_text text; /* valid until the callback returns */
  int cut;           /* the line was too long: text is its beginning */
} pizarra_news;

typedef struct {
  void *user;
  /* Opens the line anew, closing it first where it is open: not 0 when it is. Asked at most once a second. */
  int (*open)(void *user);
  /* How many of these bytes the line has taken; 0: none now; negative: it is broken. */
  int (*send)(void *user, const char *bytes, int count);
  /* How many bytes came, `room` at most; 0: none now; negative: it is broken. */
  int (*receive)(void *user, char *into, int room);
  /* It may call all of the below but pizarra_run and pizarra_begin. */
  void (*heard)(void *user, const pizarra_news *news);
} pizarra_calls;

typedef struct {
  const pizarra_calls *calls;
  const char *name;
  const char *token;
  uint32_t lease_ms;
  uint32_t now;
  uint32_t since; /* the last try to open, hello, or lease */
  uint32_t heard; /* when anything came last, or the first request went that waits */
  int16_t asked[PIZARRA_ASKED];
  int16_t last_number;
  int16_t first_asked, asked_count;
  int16_t queued, come;
  uint8_t state, cut, begun, leasing;
  char queue[PIZARRA_QUEUE];
  char line[PIZARRA_LINE];
} pizarra_device;

/* The texts outlive the device. With lease_ms 0 it has no lease. */
void pizarra_begin(pizarra_device *device, const pizarra_calls *calls, const char *name, const char *token,
                   uint32_t lease_ms);
/* Does what there is to do. Call it often; the clock may begin anywhere, and run over. */
void pizarra_run(pizarra_device *device, uint32_t now_ms);
int pizarra_joined(const pizarra_device *device);

/* Each answers the number of the request, or 0 where it cannot go now: no session, or no room. FORMS are one or more,
   one behind the other, for tell and retract. */
int pizarra_tell(pizarra_device *device, const char *forms);
int pizarra_tell_leased(pizarra_device *device, const char *forms);
int pizarra_retract(pizarra_device *device, const char *forms);
int pizarra_declare(pizarra_device *device, const char *forms);
int pizarra_ask(pizarra_device *device, const char *query);
int pizarra_watch(pizarra_device *device, int number, const char *query);
int pizarra_unwatch(pizarra_device *device, int number);

/* Reading what came: the elements of a list, the element at an index from 0, and what an element is. */
pizarra_text pizarra_inside(pizarra_text list);
pizarra_text pizarra_nth(pizarra_text elements, int index);
int pizarra_is(pizarra_text element, const char *symbol);
/* Not 0 where the element is an integer that fits. */
int pizarra_integer(pizarra_text element, int32_t *value);

/* Writing: appends to what stands in `into`, whole or not at all. Not 0 where there was room. */
int pizarra_add(char *into, int room, const char *text);
int pizarra_add_integer(char *into, int room, int32_t value);

#ifdef __cplusplus
}
#endif

#endif

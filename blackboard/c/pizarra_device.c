#include "pizarra_device.h"

#include <string.h>

enum { CLOSED, GREETING, JOINED };
enum { OPEN_AGAIN_MS = 1000, HELLO_AGAIN_MS = 3000, LONGEST_SILENCE_MS = 10000, CHUNK = 32, CHUNKS = 8 };
enum { NO_NUMBER = -1 };

static const pizarra_text nothing = {"", 0};

static void tell_user(pizarra_device *device, pizarra_kind kind, int number, pizarra_text text) {
  pizarra_news news;
  news.kind = kind;
  news.number = number;
  news.text = text;
  news.cut = device->cut;
  device->calls->heard(device->calls->user, &news);
}

/* ---- what goes */

/* A line of these pieces, whole or not at all. */
static int queue_line(pizarra_device *device, const char *const *pieces, int count) {
  size_t size = 1;
  int i;
  for (i = 0; i < count; ++i) size += strlen(pieces[i]);
  if (size > (size_t)(PIZARRA_QUEUE - device->queued)) return 0;
  for (i = 0; i < count; ++i) {
    const size_t length = strlen(pieces[i]);
    memcpy(device->queue + device->queued, pieces[i], length);
    device->queued = (int16_t)(device->queued + (int16_t)length);
  }
  device->queue[device->queued++] = '\n';
  return 1;
}

static int say_hello(pizarra_device *device) {
  /* What was left of a line by an earlier life of ours ends here. */
  const char *pieces[] = {"\n(hello ", device->name, " \"", device->token, "\")"};
  device->since = device->now;
  return queue_line(device, pieces, 5);
}

static int16_t next_number(pizarra_device *device) {
  device->last_number = (int16_t)(device->last_number == INT16_MAX ? 1 : device->last_number + 1);
  return device->last_number;
}

static int request(pizarra_device *device, const char *const *pieces, int count, int16_t number) {
  if (device->state != JOINED || device->asked_count == PIZARRA_ASKED) return 0;
  if (!queue_line(device, pieces, count)) return 0;
  if (device->asked_count == 0) device->heard = device->now;
  device->asked[(device->first_asked + device->asked_count) % PIZARRA_ASKED] = number;
  ++device->asked_count;
  return number;
}

static int request_of(pizarra_device *device, const char *verb, const char *forms) {
  const char *pieces[] = {"(", verb, " ", forms, ")"};
  return request(device, pieces, 5, next_number(device));
}

int pizarra_tell(pizarra_device *device, const char *forms) { return request_of(device, "tell", forms); }
int pizarra_tell_leased(pizarra_device *device, const char *forms) { return request_of(device, "tell-leased", forms); }
int pizarra_retract(pizarra_device *device, const char *forms) { return request_of(device, "retract", forms); }
int pizarra_declare(pizarra_device *device, const char *forms) { return request_of(device, "declare", forms); }
int pizarra_ask(pizarra_device *device, const char *query) { return request_of(device, "ask", query); }

int pizarra_watch(pizarra_device *device, int number, const char *query) {
  char digits[12] = "";
  const char *pieces[] = {"(watch ", digits, " ", query, ")"};
  pizarra_add_integer(digits, sizeof digits, number);
  return request(device, pieces, 5, next_number(device));
}

int pizarra_unwatch(pizarra_device *device, int number) {
  char digits[12] = "";
  pizarra_add_integer(digits, sizeof digits, number);
  return request_of(device, "unwatch", digits);
}

static void keep_lease(pizarra_device *device) {
  char digits[12] = "";
  const char *pieces[] = {"(lease ", digits, ")"};
  if (device->leasing || (device->begun && device->now - device->since < device->lease_ms / 3)) return;
  pizarra_add_integer(digits, sizeof digits, (int32_t)device->lease_ms);
  if (!request(device, pieces, 3, NO_NUMBER)) return;
  device->leasing = 1;
  device->begun = 1;
  device->since = device->now;
}

/* ---- what comes */

static void close_line(pizarra_device *device, pizarra_text why) {
  const uint8_t was = device->state;
  device->state = CLOSED;
  device->begun = 1;
  device->since = device->now;
  device->asked_count = 0;
  if (was == JOINED) tell_user(device, PIZARRA_GONE, 0, why);
}

static void answered(pizarra_device *device, pizarra_kind kind, pizarra_text text) {
  int16_t number;
  if (device->asked_count == 0) {
    close_line(device, nothing);
    return;
  }
  number = device->asked[device->first_asked];
  device->first_asked = (int16_t)((device->first_asked + 1) % PIZARRA_ASKED);
  --device->asked_count;
  if (number != NO_NUMBER) {
    tell_user(device, kind, number, text);
    return;
  }
  device->leasing = 0;
  if (kind == PIZARRA_OK && pizarra_is(pizarra_nth(text, 0), "new")) tell_user(device, PIZARRA_LEASED, 0, nothing);
}

static void joined(pizarra_device *device) {
  /* Who said hello twice is welcomed twice. */
  if (device->state == JOINED) return;
  device->state = JOINED;
  device->asked_count = 0;
  device->leasing = 0;
  device->begun = 0;
  tell_user(device, PIZARRA_JOINED, 0, nothing);
}

/* Not 0 where it was a change of a watch. */
static int changed(pizarra_device *device, pizarra_text head, pizarra_text rest) {
  static const struct {
    const char *word;
    pizarra_kind kind;
  } words[] = {{"came", PIZARRA_CAME}, {"went", PIZARRA_WENT}, {"now", PIZARRA_NOW}, {"anew", PIZARRA_ANEW},
               {"lost", PIZARRA_LOST}};
  const pizarra_text first = pizarra_nth(rest, 0);
  const pizarra_text second = pizarra_nth(rest, 1);
  pizarra_text text = nothing;
  int32_t number;
  unsigned i;
  if (!pizarra_integer(first, &number)) return 0;
  if (second.size > 0) {
    text.at = second.at;
    text.size = (int)(rest.at + rest.size - second.at);
  }
  for (i = 0; i < sizeof words / sizeof *words; ++i) {
    if (!pizarra_is(head, words[i].word)) continue;
    tell_user(device, words[i].kind, (int)number, text);
    return 1;
  }
  return 0;
}

static void hear_line(pizarra_device *device) {
  pizarra_text line;
  pizarra_text head;
  pizarra_text rest;
  line.at = device->line;
  line.size = device->come;
  if (device->cut && line.size > 1) device->line[line.size - 1] = ')';
  rest = pizarra_inside(line);
  head = pizarra_nth(rest, 0);
  if (head.size > 0) {
    rest.size -= (int)(head.at + head.size - rest.at);
    rest.at = head.at + head.size;
  }
  if (pizarra_is(head, "welcome")) {
    joined(device);
  } else if (device->state != JOINED) {
    /* What else came is of an earlier session. Of a refusal hello is said again, in case the line was disturbed. */
    if (pizarra_is(head, "closed")) tell_user(device, PIZARRA_GONE, 0, rest);
  } else if (pizarra_is(head, "ok")) {
    answered(device, PIZARRA_OK, rest);
  } else if (pizarra_is(head, "fail")) {
    answered(device, PIZARRA_FAIL, rest);
  } else if (!changed(device, head, rest)) {
    close_line(device, pizarra_is(head, "closed") ? rest : nothing);
  }
}

static void hear(pizarra_device *device, char c) {
  if (c == '\n' || c == '\r') {
    if (device->come > 0) hear_line(device);
    device->come = 0;
    device->cut = 0;
  } else if (device->come < PIZARRA_LINE - 1) {
    device->line[device->come++] = c;
  } else {
    device->cut = 1;
  }
}

/* Whether the line goes on. */
static int receive(pizarra_device *device) {
  char chunk[CHUNK];
  int i;
  int n;
  for (i = 0; i < CHUNKS; ++i) {
    const int count = device->calls->receive(device->calls->user, chunk, CHUNK);
    if (count < 0) return 0;
    if (count == 0) return 1;
    device->heard = device->now;
    for (n = 0; n < count; ++n) {
      hear(device, chunk[n]);
      if (device->state == CLOSED) return 1;
    }
  }
  return 1;
}

static int transmit(pizarra_device *device) {
  int sent;
  if (device->queued == 0) return 1;
  sent = device->calls->send(device->calls->user, device->queue, device->queued);
  if (sent < 0) return 0;
  memmove(device->queue, device->queue + sent, (size_t)(device->queued - sent));
  device->queued = (int16_t)(device->queued - sent);
  return 1;
}

/* ---- life */

void pizarra_begin(pizarra_device *device, const pizarra_calls *calls, const char *name, const char *token,
                   uint32_t lease_ms) {
  memset(device, 0, sizeof *device);
  device->calls = calls;
  device->name = name;
  device->token = token;
  device->lease_ms = lease_ms;
}

int pizarra_joined(const pizarra_device *device) { return device->state == JOINED; }

static void open_line(pizarra_device *device) {
  if (device->begun && device->now - device->since < OPEN_AGAIN_MS) return;
  device->begun = 1;
  device->since = device->now;
  if (!device->calls->open(device->calls->user)) return;
  device->state = GREETING;
  device->heard = device->now;
  device->queued = 0;
  device->come = 0;
  device->cut = 0;
  say_hello(device);
}

void pizarra_run(pizarra_device *device, uint32_t now_ms) {
  device->now = now_ms;
  if (device->state == CLOSED) open_line(device);
  if (device->state == CLOSED) return;
  if (!receive(device)) close_line(device, nothing);
  if (device->state == CLOSED) return;
  if ((device->state == GREETING || device->asked_count > 0) && now_ms - device->heard >= LONGEST_SILENCE_MS) {
    close_line(device, nothing);
    return;
  }
  if (device->state == GREETING && device->queued == 0 && now_ms - device->since >= HELLO_AGAIN_MS) say_hello(device);
  if (device->state == JOINED && device->lease_ms > 0) keep_lease(device);
  if (!transmit(device)) close_line(device, nothing);
}

/* ---- reading and writing */

static int is_blank(char c) { return c == ' ' || c == '\t'; }

/* Behind the element that begins at `i`, which is no blank. */
static int end_of_element(const char *text, int i, int size) {
  int depth = 0;
  int in_string = 0;
  for (; i < size; ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = 0;
    } else if (c == '"') {
      in_string = 1;
    } else if (c == '(') {
      ++depth;
    } else if (c == ')') {
      --depth;
    }
    if (depth < 0) return i;
    if (depth > 0 || in_string) continue;
    if (i + 1 >= size || is_blank(text[i + 1]) || text[i + 1] == '(' || text[i + 1] == ')' || c == '"' || c == ')') {
      return i + 1;
    }
  }
  return size;
}

pizarra_text pizarra_inside(pizarra_text list) {
  pizarra_text inside = nothing;
  if (list.size < 2 || list.at[0] != '(' || list.at[list.size - 1] != ')') return inside;
  inside.at = list.at + 1;
  inside.size = list.size - 2;
  return inside;
}

pizarra_text pizarra_nth(pizarra_text elements, int index) {
  pizarra_text element = nothing;
  int i = 0;
  for (;;) {
    int end;
    while (i < elements.size && is_blank(elements.at[i])) ++i;
    if (i >= elements.size) return nothing;
    end = end_of_element(elements.at, i, elements.size);
    if (end <= i) return nothing;
    if (index-- == 0) {
      element.at = elements.at + i;
      element.size = end - i;
      return element;
    }
    i = end;
  }
}

int pizarra_is(pizarra_text element, const char *symbol) {
  const size_t length = strlen(symbol);
  return element.size > 0 && (size_t)element.size == length && memcmp(element.at, symbol, length) == 0;
}

int pizarra_integer(pizarra_text element, int32_t *value) {
  const int negative = element.size > 0 && element.at[0] == '-';
  const int sign = negative || (element.size > 0 && element.at[0] == '+');
  int32_t sum = 0;
  int i;
  if (element.size <= sign) return 0;
  for (i = sign; i < element.size; ++i) {
    const int32_t digit = element.at[i] - '0';
    if (digit < 0 || digit > 9) return 0;
    /* Counted below zero, where there is one more. */
    if (sum < (INT32_MIN + digit) / 10) return 0;
    sum = sum * 10 - digit;
  }
  if (!negative && sum == INT32_MIN) return 0;
  *value = negative ? sum : -sum;
  return 1;
}

int pizarra_add(char *into, int room, const char *text) {
  const size_t there = strlen(into);
  const size_t more = strlen(text);
  if (there + more + 1 > (size_t)room) return 0;
  memcpy(into + there, text, more + 1);
  return 1;
}

int pizarra_add_integer(char *into, int room, int32_t value) {
  char digits[12];
  int i = (int)sizeof digits - 1;
  uint32_t left = value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
  digits[i] = 0;
  do {
    digits[--i] = (char)('0' + left % 10);
    left /= 10;
  } while (left > 0);
  if (value < 0) digits[--i] = '-';
  return pizarra_add(into, room, digits + i);
}

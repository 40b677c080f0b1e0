/* SPDX-License-Identifier: MIT */
/* The message by which a host sets a file: what it says, and that nothing beyond its end is read,
 * whatever it says. */
#include "lv2/set_path.h"

#include <lv2/patch/patch.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "midi_writer.h"
#include "plugin_host.h"

#define PROPERTY "urn:test:file"
#define PATH "/kits/mine.ini"

/* A patch:Set with further properties before and between. */
typedef struct Message {
  LV2_Atom_Event event;
  LV2_Atom_Object_Body object;
  LV2_Atom_Property_Body property;
  LV2_URID uri, padding;
  LV2_Atom_Property_Body other;
  int64_t number;
  LV2_Atom_Property_Body value;
  char path[sizeof PATH + 1];
} Message;

static Message valid_message(void) {
  Message message = {
    .event = {.body = {.size =
                         (uint32_t)(offsetof(Message, path) + sizeof PATH - sizeof(LV2_Atom_Event)),
                       .type = host_map(LV2_ATOM__Object)}},
    .object = {.otype = host_map(LV2_PATCH__Set)},
    .property = {.key = host_map(LV2_PATCH__property),
                 .value = {.size = sizeof(LV2_URID), .type = host_map(LV2_ATOM__URID)}},
    .uri = host_map(PROPERTY),
    .other = {.key = host_map("urn:test:else"),
              .value = {.size = sizeof(int64_t), .type = host_map(LV2_ATOM__Long)}},
    .value = {.key = host_map(LV2_PATCH__value),
              .value = {.size = sizeof PATH, .type = host_map(LV2_ATOM__Path)}}};
  memcpy(message.path, PATH, sizeof PATH);
  return message;
}

/* From memory that ends where the event does. */
static bool gives_path(const Message *message, size_t size, const char *expected) {
  LV2_URID_Map map = {.map = host_map_feature};
  const SetPathUrids urids = set_path_urids(&map);
  LV2_Atom_Event *const event = malloc(size);
  size_t length = 0;
  assert_non_null(event);
  memcpy(event, message, size);
  event->body.size = (uint32_t)(size - sizeof *event);
  const char *const path = set_path_read(event, &urids, host_map(PROPERTY), &length);
  const bool same =
    path && expected && length == strlen(expected) && memcmp(path, expected, length) == 0;
  assert_true(!path || length < size);
  free(event);
  return expected ? same : path != NULL;
}

static size_t whole(const Message *message) {
  return sizeof message->event + message->event.body.size;
}

static void a_path_is_read(void **state) {
  (void)state;
  const Message message = valid_message();
  assert_true(gives_path(&message, whole(&message), PATH));
  assert_false(gives_path(&message, whole(&message) - 1, NULL)); /* it is cut off */
}

static void other_messages_give_none(void **state) {
  (void)state;
  for (int i = 0; i < 5; i++) {
    Message message = valid_message();
    LV2_URID *const changed[] = {&message.event.body.type, &message.object.otype, &message.uri,
                                 &message.value.key, &message.value.value.type};
    *changed[i] = host_map("urn:test:nothing");
    assert_false(gives_path(&message, whole(&message), NULL));
  }
}

static void nothing_beyond_the_end_is_read(void **state) {
  (void)state;
  uint64_t random = 1;
  print_message("seed %u\n", (unsigned)random);
  for (int trial = 0; trial < 20000; trial++) {
    Message message = valid_message();
    uint8_t *const bytes = (uint8_t *)&message;
    const size_t size = sizeof message.event + midi_random(&random) % (message.event.body.size + 1);
    for (int i = 0; i < 3; i++) {
      bytes[sizeof message.event + midi_random(&random) % message.event.body.size] =
        (uint8_t)midi_random(&random);
    }
    (void)gives_path(&message, size, NULL);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_path_is_read),
    cmocka_unit_test(other_messages_give_none),
    cmocka_unit_test(nothing_beyond_the_end_is_read),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}

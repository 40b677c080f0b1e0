/* SPDX-License-Identifier: MIT */
#include "saved_model/transfer.h"

#include <stdint.h>
#include <string.h>

#include "math/arena.h"

static void *read_pointer(const void *pointer) {
  void *array;
  memcpy(&array, pointer, sizeof array);
  return array;
}

/* The next array takes `bytes`, of which there are enough. */
static void pass(TbTransfer *t, size_t bytes) { t->at = TB_ALIGNED(t->at + bytes); }

static void fail(TbTransfer *t, void *pointer) {
  const void *const none = NULL;
  memcpy(pointer, &none, sizeof none);
  t->failed = true;
}

static void read_array(TbTransfer *t, void *pointer, size_t bytes) {
  uintptr_t offset;
  memcpy(&offset, pointer, sizeof offset);
  if (t->failed || offset != t->at || t->at > t->size || bytes > t->size - t->at) {
    fail(t, pointer);
    return;
  }
  const void *const array = t->block + t->at;
  memcpy(pointer, &array, sizeof array);
  pass(t, bytes);
}

static void write_array(TbTransfer *t, void *pointer, size_t bytes) {
  const uintptr_t offset = t->at;
  const size_t place = t->record.at + (size_t)((const char *)pointer - t->record.memory);
  if (t->block) {
    memcpy(t->block + t->at, read_pointer(pointer), bytes);
    memset(t->block + t->at + bytes, 0, TB_ALIGNED(t->at + bytes) - t->at - bytes);
    memcpy(t->block + place, &offset, sizeof offset);
  }
  pass(t, bytes);
}

void tb_transfer_array(TbTransfer *t, void *pointer, size_t size, size_t count) {
  if (!read_pointer(pointer)) return;
  if (count > SIZE_MAX / 2 / size) {
    if (t->reads) fail(t, pointer);
    return;
  }
  (t->reads ? read_array : write_array)(t, pointer, size * count);
}

TbRecord tb_transfer_begin_records(TbTransfer *t, void *pointer, size_t size, size_t count) {
  const TbRecord before = t->record;
  const size_t at = t->at;
  tb_transfer_array(t, pointer, size, count);
  t->record = (TbRecord){.memory = read_pointer(pointer), .at = at};
  return before;
}

void tb_transfer_end_records(TbTransfer *t, TbRecord before) { t->record = before; }

/* SPDX-License-Identifier: MIT */
/* Moves arrays between memory and one block of bytes. One list of arrays (model_arrays.h) serves
 * both ways.
 *
 * The block holds a record, a struct as it lies in memory, and after it the arrays to which its
 * pointers lead, each at a multiple of 64 bytes, in the order of the list. Arrays of structs with
 * pointers are records again. In the block a pointer holds the offset of its array, or 0 for NULL.
 * Reading puts addresses in place of offsets, and fails if an offset is not the one that the list
 * leads to, or if an array does not fit. Set-up only. */
#ifndef TB_TRANSFER_H
#define TB_TRANSFER_H

#include <stdbool.h>
#include <stddef.h>

/* A record whose pointers are listed: where it lies in memory and in the block. */
typedef struct TbRecord {
  const char *memory;
  size_t at;
} TbRecord;

typedef struct TbTransfer {
  char *block;     /* NULL: nothing is moved, `at` counts */
  size_t at, size; /* the next array's offset, and the block's bytes, which reading keeps to */
  TbRecord record;
  bool reads, failed;
} TbTransfer;

/* Moves the array of `count` elements of `size` bytes to which the pointer at `pointer` leads, if
 * it is not NULL. */
void tb_transfer_array(TbTransfer *transfer, void *pointer, size_t size, size_t count);
/* The same for an array of records. Then list what is in them, and call tb_transfer_end_records()
 * with what this returns. */
TbRecord tb_transfer_begin_records(TbTransfer *transfer, void *pointer, size_t size, size_t count);
void tb_transfer_end_records(TbTransfer *transfer, TbRecord before);

#endif

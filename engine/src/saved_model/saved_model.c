/* SPDX-License-Identifier: MIT */
/* A built model as bytes: a head, then the block of saved_model/transfer.h, whose record is the
 * model. */
#include <math.h>
#include <string.h>

#include "definition/error.h"
#include "math/checksum.h"
#include "saved_model/model_arrays.h"

enum { VERSION_SIZE = 32 };

/* Before the block, which begins at the next multiple of TB_ALIGNMENT. */
typedef struct Head {
  char magic[8];
  char version[VERSION_SIZE];
  uint64_t model_bytes; /* sizeof(TaborModel), which differs where pointers or structs do */
  uint64_t block_bytes;
  uint64_t checksum; /* of the block */
} Head;

static const char MAGIC[8] = {'t', 'a', 'b', 'o', 'r', 'm', 'd', 'l'};
static const size_t HEAD = TB_ALIGNED(sizeof(Head));
static const size_t RECORD = TB_ALIGNED(sizeof(TaborModel));

/* Writes the block, or with NULL counts its bytes. Writing only reads the model. */
static size_t write_block(const TaborModel *model, char *block) {
  TbTransfer transfer = {.block = block, .at = RECORD, .record = {.memory = (const char *)model}};
  if (block) {
    memset(block, 0, RECORD);
    memcpy(block, model, sizeof *model);
  }
  tb_model_arrays(&transfer, (TaborModel *)model);
  return transfer.at;
}

static Head head_of(size_t block_bytes) {
  Head head = {.model_bytes = sizeof(TaborModel), .block_bytes = block_bytes};
  memcpy(head.magic, MAGIC, sizeof head.magic);
  strncpy(head.version, tabor_version(), sizeof head.version - 1u);
  return head;
}

size_t tabor_model_saved_size(const TaborModel *model) { return HEAD + write_block(model, NULL); }

/* Leaves out the parts that belong to this process. A model is too large for some threads' stacks,
 * and the block may be anywhere. */
static void clear_own(char *block) {
#define CLEAR(part) memset(block + offsetof(TaborModel, part), 0, sizeof((TaborModel *)0)->part)
  CLEAR(references);
  CLEAR(arena);
  CLEAR(kernels);
  CLEAR(kernelsf);
#undef CLEAR
}

void tabor_model_save(const TaborModel *model, void *bytes) {
  char *const block = (char *)bytes + HEAD;
  const size_t size = write_block(model, block);
  Head head = head_of(size);
  clear_own(block);
  head.checksum = tb_checksum(block, size);
  memset(bytes, 0, HEAD);
  memcpy(bytes, &head, sizeof head);
}

/* ---- loading -------------------------------------------------------------------------------- */

static TaborStatus refuse(TaborError *error, const char *why) {
  return tb_error_set(error, TABOR_ERROR_STATE, NULL, NULL, NAN, NAN, "%s", why);
}

static TaborStatus check_bytes(const void *bytes, size_t size, TaborError *error) {
  Head head;
  if (size < HEAD + RECORD) return refuse(error, "the saved model is cut off");
  memcpy(&head, bytes, sizeof head);
  const Head own = head_of(size - HEAD);
  if (memcmp(head.magic, own.magic, sizeof own.magic) != 0) {
    return refuse(error, "these bytes are no saved model");
  }
  if (memcmp(head.version, own.version, sizeof own.version) != 0 ||
      head.model_bytes != own.model_bytes) {
    return refuse(error,
                  "the saved model is of another version of Tabor, or of another kind of machine");
  }
  if (head.block_bytes != own.block_bytes)
    return refuse(error, "the saved model is cut off, or too long");
  if (head.checksum != tb_checksum((const char *)bytes + HEAD, size - HEAD)) {
    return refuse(error, "the saved model is damaged");
  }
  return TABOR_OK;
}

/* Puts a model together whose block is in its arena. */
static TaborStatus put_together(TaborModel *model, char *block, size_t size, TaborError *error) {
  TbTransfer transfer = {.block = block,
                         .at = RECORD,
                         .size = size,
                         .record = {.memory = (const char *)model},
                         .reads = true};
  TbArena arena = model->arena;
  memcpy(model, block, sizeof *model);
  atomic_init(&model->references, 1u);
  model->arena = arena;
  tb_model_arrays(&transfer, model);
  if (transfer.failed || transfer.at != size ||
      tabor_drum_def_validate(&model->def, NULL) != TABOR_OK ||
      tb_model_fingerprint(model) != model->fingerprint) {
    return refuse(error, "the saved model contradicts itself");
  }
  return TABOR_OK;
}

TaborStatus tabor_model_load(const void *bytes, size_t size, const TaborModelOptions *options,
                             TaborModel **out, TaborError *error) {
  TaborModelOptions chosen;
  if (!out) return tb_error_null(error, "place for the model");
  *out = NULL;
  if (!bytes) return tb_error_null(error, "saved model");
  TaborStatus status = tb_model_resolve_options(options, &chosen, error);
  if (status == TABOR_OK) status = check_bytes(bytes, size, error);
  if (status != TABOR_OK) return status;
  TaborModel *model = tb_model_allocate(&chosen, error);
  if (!model) return TABOR_ERROR_MEMORY;
  /* Kernels may read up to a register beyond an array's end. */
  char *block = tb_arena_take(&model->arena, size - HEAD + TB_ALIGNMENT, 1u);
  if (block) {
    memcpy(block, (const char *)bytes + HEAD, size - HEAD);
    status = put_together(model, block, size - HEAD, error);
    tb_model_choose_kernels(model, chosen.instructions);
  } else {
    status = tb_model_memory_error(error);
  }
  if (status == TABOR_OK) {
    *out = model;
  } else {
    tabor_model_release(model);
  }
  return status;
}

/* SPDX-License-Identifier: MIT */
/**
 * @file library_kit.h
 * A kit as a sample library: each kind of stroke on each drum is a sound of its own, in the kit's
 * stereo mix, with what the other drums answer. A sound is that of `tabor render --kit` for a song
 * of this one note, to the bit.
 */
#ifndef TABOR_HOST_LIBRARY_KIT_H
#define TABOR_HOST_LIBRARY_KIT_H

#include <tabor/kit.h>

#include "library/library_request.h"
#include "render/render_batch.h"

struct LibraryKit {
  TaborKitDef def;
  TaborModel *models[TABOR_KIT_DRUMS]; /**< once they are built */
};

/** Reads --kit, and plans its sounds in @p shape. */
Outcome library_kit_read(const Arguments *arguments, const LibraryShape *shape,
                         LibraryRequest *request);
/** Reads how its sounds are rendered. */
Outcome library_kit_read_rendering(const Arguments *arguments, LibraryRequest *request);
void library_kit_free(LibraryKit *kit);

/** Builds the models of @p request's kit. */
Outcome library_kit_build(const LibraryRequest *request);
/** Prepares @p job, whose output is set, to render @p sound by library_kit_render(). */
void library_kit_prepare(const LibraryRequest *request, const LibrarySound *sound, RenderJob *job);
/** A RenderJobFn: @p sums are a LibrarySums. */
Outcome library_kit_render(void *sums, RenderJob *job);

#endif

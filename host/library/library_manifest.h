/* SPDX-License-Identifier: MIT */
/**
 * @file library_manifest.h
 * What makes a folder a sample library: the file tabor-library.json, which holds everything that the
 * bytes of its sounds depend on. A folder belongs to one request, so that a run that was ended can be
 * taken up again and never mixes two libraries; and to one run at a time.
 */
#ifndef TABOR_HOST_LIBRARY_MANIFEST_H
#define TABOR_HOST_LIBRARY_MANIFEST_H

#include "library/library_request.h"

#define LIBRARY_MANIFEST "tabor-library.json"

/**
 * Takes the request's folder, which is created if need be, for this run. Refused if it holds another
 * library, or sounds of these names without a manifest; fails if another run is at work there. Removes what
 * a run that was killed has left half-written. The folder is held until *hold is closed, and by -1 not
 * at all.
 */
Outcome library_manifest_claim(const LibraryRequest *request, int *hold);

#endif

/* SPDX-License-Identifier: MIT */
/**
 * @file library_manifest.h
 * The manifest of a sample library, tabor-library.json. It holds everything that the bytes of the
 * sounds depend on. A folder belongs to one request, so an unfinished run can be resumed and two
 * libraries never mix. One run at a time may hold a folder.
 */
#ifndef TABOR_HOST_LIBRARY_MANIFEST_H
#define TABOR_HOST_LIBRARY_MANIFEST_H

#include "library/library_request.h"

#define LIBRARY_MANIFEST "tabor-library.json"

/**
 * Claims the request's folder for this run; creates it if needed. Refuses a folder that holds
 * another library, or sounds of these names without a manifest; fails if another run holds it.
 * Removes the partial files of a killed run. The folder is held until *hold is closed; *hold is -1
 * if it is not held.
 */
Outcome library_manifest_claim(const LibraryRequest *request, int *hold);

#endif

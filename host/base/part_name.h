/* SPDX-License-Identifier: MIT */
/**
 * @file part_name.h
 * Names that a person finds for files that are not complete.
 */
#ifndef TABOR_HOST_PART_NAME_H
#define TABOR_HOST_PART_NAME_H

/** "FOLDER/take.part.wav" of "FOLDER/take.wav"; "take.part-2.wav" with the number 2. The caller
 * frees it; NULL if memory is short. */
char *part_name(const char *target, unsigned number);

#endif

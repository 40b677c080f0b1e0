/* SPDX-License-Identifier: MIT */
/**
 * @file definition.h
 * Values that the model derives from a definition's fields.
 */
#ifndef TABOR_SRC_DEFINITION_H
#define TABOR_SRC_DEFINITION_H

#include "tabor/tabor.h"

/**
 * The complete values of wire @p index (from 0) of a valid definition, none of them NaN: the wire's
 * own values if set, otherwise those of [wires].
 *
 * - tension: with the spread applied, T (1 + spread u), u in [-1, 1] from seed and index; a wire's
 *   own tension has no spread. The spread may carry the tension past the range of the key.
 * - rest offset: with its spread applied; a wire's own rest offset has no spread.
 * - angle: wires.angle unless the wire has its own.
 * - offset: wires.offset + (index - (count - 1)/2) spacing unless the wire has its own.
 *
 * Integer arithmetic and exactly rounded operations only: the same on every machine.
 */
void tb_wire_resolve(const TaborDrumDef *def, unsigned index, TaborWireDef *wire);

/** Pseudo-random uniform number in [-1, 1] for @p seed and the index of a wire or lug. */
double tb_deviate(uint32_t seed, uint32_t index);

/** Index of the striker named by strike.striker ("" is the first), or -1. */
int tb_strike_striker(const TaborDrumDef *def);

/** True if @p mic of a valid definition stands in the air that the shell encloses. */
bool tb_mic_is_inside(const TaborDrumDef *def, const TaborMicDef *mic);

/** Writes the indices of the microphones outside the shell to @p mics[TABOR_MAX_MICS]; returns
 * how many there are. */
uint32_t tb_mics_outside(const TaborDrumDef *def, uint32_t *mics);

/** Checks that @p def is not NULL and has this library's size. */
TaborStatus tb_check_struct(const TaborDrumDef *def, TaborError *error);

/** Reports that a striker's or microphone's name is not in @p def, and names the nearest that
 * is. */
TaborStatus tb_refuse_name(const TaborDrumDef *def, bool is_mic, const char *key, const char *name,
                           TaborError *error);

#endif /* TABOR_SRC_DEFINITION_H */

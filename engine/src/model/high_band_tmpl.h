/* SPDX-License-Identifier: MIT */
/* Defines TbRinging and TbRingingF, the coefficients of the high band: see high_band.h and
 * both.h. */
typedef struct TB_TYPE(TbRinging) {
  TB_REAL *a, *b; /* the recursion: see modes.h; all arrays are [padded] */
  TB_REAL *walk; /* square of the largest turn per step by which scattering moves a mode, 0: none */
  TB_REAL *hold; /* k phi^2/2, phi^2 its mean over the bed, of the wires' head [s/kg] */
  TB_REAL *ahead[TABOR_MAX_MICS], *behind[TABOR_MAX_MICS]; /* weights of microphones: see TbMic */
} TB_TYPE(TbRinging);

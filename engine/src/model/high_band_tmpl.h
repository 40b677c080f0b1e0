/* SPDX-License-Identifier: MIT */
/* The text of TbRinging and TbRingingF, the numbers that move the high band: see high_band.h and both.h. */
typedef struct TB_TYPE(TbRinging) {
  TB_REAL *a, *b; /* [padded], as are all, the recursion: see modes.h */
  TB_REAL *hold;  /* k phi^2/2, phi^2 its mean over the bed, of the wires' head [s/kg] */
  TB_REAL *ahead[TABOR_MAX_MICS], *behind[TABOR_MAX_MICS]; /* weights of microphones: see TbMic */
} TB_TYPE(TbRinging);

/* SPDX-License-Identifier: MIT */
/* Defines TbKernels and TbKernelsF: see both.h. A row is one contact. `lanes` counts the contact
 * points along a wire; l in an index 8 b + l is a SIMD lane. */

/* Products of a table's first `part` columns, of n, with one or two vectors. `blocks` blocks of
 * eight rows come from `matrix`. The `rest` rows after them come from the transposed table,
 * [n/8][stride][8], where the terms of a row are contiguous. In single precision part is a multiple
 * of 4, and of 8 if there are rest rows. */
typedef struct TB_TYPE(TbGather) {
  uint32_t vectors, blocks, n, part;
  uint32_t rest, stride;
  const TB_REAL *matrix, *transposed;
#if !TB_REAL_IS_FLOAT
  const float *rounded; /* in place of `matrix`, for `gemm_rounded` */
#endif
  const TB_REAL *x[TB_COUPLINGS];
  double *out[TB_COUPLINGS];
} TB_TYPE(TbGather);

/* A step of the high band and the signal of one microphone (mic_output.h). Arrays are [modes].
 * `push_by_sound` is read for pushed modes, `held` for held ones. */
typedef struct TB_TYPE(TbRing) {
  TbRingParts parts;
  const TB_REAL *a, *b, *now, *last, *held, *ahead, *behind;
  const float *push;
  TB_REAL share; /* of push[] */
  TB_REAL *next;
} TB_TYPE(TbRing);

/* Scattering of eight modes of the high band (high_band_step.h): `draw` is from -1 to 1, and walk +
 * wires held the square of the turn per step that its size is of. Arrays are [8]. */
typedef struct TB_TYPE(TbScattering) {
  const TB_REAL *a, *b, *walk, *held, *draw, *now;
  TB_REAL wires;
  TB_REAL *last, *turn;
} TB_TYPE(TbScattering);

/* The start of a contact solve: copies of p and f, s = b - p, the largest |b|, the largest y or 0,
 * and the largest |f|. */
typedef struct TB_TYPE(TbStart) {
  const double *from_b, *from_p, *from_y, *from_f;
  TB_REAL *p, *f, *s;
#if TB_REAL_IS_FLOAT
  const double *from_contact_compliance;
  const TB_REAL *head; /* the head's compliance at a row */
  TB_REAL *b, *y, *root, *contact_compliance,
    *yield;      /* copies, sqrt(y) or 0, and its sum with `head` */
  TB_REAL force; /* the largest |f| */
#endif
  TB_REAL change, depth;
} TB_TYPE(TbStart);

/* The end of a contact solve: f + t (f - f_last), the same for p, and s = b - p, in double,
 * possibly in place; Sum s (law - mean); and the number of slopes > 0. */
typedef struct TB_TYPE(TbEnd) {
  TB_REAL t;
  const TB_REAL *b, *f, *f_last, *p, *p_last, *law, *mean, *slope;
  double *to_f, *to_p, *to_s;
  TB_REAL lost;
  uint32_t touching;
} TB_TYPE(TbEnd);

/* The largest residual, and the squared norm of the right-hand side of a Newton step. */
typedef struct TB_TYPE(TbResidual) {
  TB_REAL largest, square;
} TB_TYPE(TbResidual);

/* The terms of a balance (solve.h), and the largest |law - f|. */
typedef struct TB_TYPE(TbBalance) {
  TB_REAL value, derivative, size, miss;
} TB_TYPE(TbBalance);

#if TB_REAL_IS_FLOAT
/* One pass over the rows of wires, `lanes` rows each, at the forces f + t g of TbBalance. `balance`
 * has its sums; `way` is the largest |s|, `lost` Sum s (law - mean), `touching` the number of
 * slopes > 0. */
typedef struct TbTrial {
  uint32_t wires, lanes;
  const TbContactLaw *laws;
  float t;
  const float *b, *y, *root, *yield, *f, *f_last, *p, *p_last;
  TbBalanceF balance;
  float way, lost;
  uint32_t touching;
} TbTrial;
#endif

typedef struct TB_TYPE(TbKernels) {
  /* ---- vectors and tables, in either precision --------------------------------------------- */

  /* Sum x y */
  TB_REAL (*dot)(uint32_t n, const TB_REAL *x, const TB_REAL *y);
  /* Sum u x and Sum v x */
  TbPair (*two_dots)(uint32_t n, const TB_REAL *u, const TB_REAL *v, const TB_REAL *x);
  /* out += f x; out += x y; out = x y */
  void (*axpy)(uint32_t n, TB_REAL *out, TB_REAL f, const TB_REAL *x);
  void (*add_product)(uint32_t n, TB_REAL *out, const TB_REAL *x, const TB_REAL *y);
  void (*product)(uint32_t n, TB_REAL *out, const TB_REAL *x, const TB_REAL *y);
  /* Largest |x - y| */
  TB_REAL (*difference)(uint32_t n, const TB_REAL *x, const TB_REAL *y);
  /* out = base + t (x - before) */
  void (*extrapolate)(uint32_t n, TB_REAL t, const TB_REAL *x, const TB_REAL *before,
                      const TB_REAL *base, TB_REAL *out);
  /* out[8 b + l] = Sum_i matrix[b][i][l] x[i], i ascending, for b < blocks, i < n */
  void (*gemv)(uint32_t blocks, uint32_t n, TB_REAL *out, const TB_REAL *matrix, const TB_REAL *x);
  /* out[v][8 b + l] = Sum_i matrix[b][i][l] x[v][i], i < part; in double, i ascending */
  void (*gemm)(const TB_TYPE(TbGather) * gather);
  /* out[h] = G q of head h off the diagonal, at the modes of the blocks that move; others of `q`
   * are 0. */
  void (*mix)(const TbMixing *mixing, const TbParts *moving, const double *q,
              double *const out[TB_COUPLINGS]);
  /* next = a now - b last + share push, then next += held (last - next). Returns Sum ahead next and
   * Sum behind next. */
  TbPair (*resonate)(const TB_TYPE(TbRing) * ring);
  /* turn = 2 sqrt(b) cos(p + d), p the turn per step of a, d = draw sqrt(walk + wires held). `last`
   * follows, so that the motion keeps amplitude and phase at `now`. Modes with walk = 0 stay. */
  void (*turn_phases)(const TB_TYPE(TbScattering) * scattering);

  /* ---- contacts (solve.h), in either precision ---------------------------------------------- */

  /* From rows x[wires * lanes] to the grid under the wires (wire_grid.h), back to rows, and out = G
   * grid. */
  void (*rows_to_grid)(const TB_TYPE(TbWireGrid) * wire_grid, const TB_REAL *x, TB_REAL *scratch,
                       TB_REAL *grid);
  void (*grid_to_rows)(const TB_TYPE(TbWireGrid) * wire_grid, const TB_REAL *grid, TB_REAL *scratch,
                       TB_REAL *x);
  void (*apply_compliance)(const TB_TYPE(TbCompliance) * compliance, const TB_REAL *grid,
                           TB_REAL *out);
  void (*start)(uint32_t n, TB_TYPE(TbStart) * start);
  void (*finish)(uint32_t n, TB_TYPE(TbEnd) * end);
  /* The laws of `wires` wires with `lanes` rows each: force and slope at s, and the mean of V'
   * between y and y + s. root = sqrt(y), 0 where y < 0, or NULL. */
  void (*laws)(uint32_t wires, uint32_t lanes, const TbContactLaw *laws, const TB_REAL *y,
               const TB_REAL *root, const TB_REAL *s, TB_REAL *force, TB_REAL *slope,
               TB_REAL *mean);
  /* s = b - p; returns the largest |s| */
  TB_REAL (*change)(uint32_t n, const TB_REAL *b, const TB_REAL *p, TB_REAL *s);
  /* Conjugate gradients: out = d + w m, returns Sum d out; p += t d and r -= t m, returns Sum r r;
   * d = r + t d. */
  TB_REAL(*cg_apply)
  (uint32_t n, TB_REAL *out, const TB_REAL *d, const TB_REAL *w, const TB_REAL *m);
  TB_REAL(*cg_advance)
  (uint32_t n, TB_REAL t, TB_REAL *p, const TB_REAL *d, TB_REAL *r, const TB_REAL *m);
  void (*xpby)(uint32_t n, TB_REAL t, TB_REAL *d, const TB_REAL *r);
  /* f = law + weight x, s = b - p; returns the largest |s| */
  TB_REAL(*newton_finish)
  (uint32_t n, const TB_REAL *law, const TB_REAL *weight, const TB_REAL *x, const TB_REAL *b,
   const TB_REAL *p, TB_REAL *f, TB_REAL *s);
  /* With g = f - f_last, m = p - p_last, f' = f + t g: Sum s (law - f'); its derivative in t, which
   * is -Sum m (law - f') + s (slope m + g); Sum |s f'|; the largest |law - f'|, in single
   * precision divided by 1 + slope yield, or 0 if yield is NULL there. */
  TB_TYPE(TbBalance)
  (*balance)(uint32_t n, TB_REAL t, const TB_REAL *yield, const TB_REAL *s, const TB_REAL *law,
             const TB_REAL *slope, const TB_REAL *f, const TB_REAL *f_last, const TB_REAL *p,
             const TB_REAL *p_last);

#if TB_REAL_IS_FLOAT
  /* ---- beside the state, which is double ---------------------------------------------------- */

  /* Conversion of x, and of x - y, to single precision; conversion of x to double. */
  void (*narrow)(uint32_t n, const double *x, float *out);
  void (*narrow_change)(uint32_t n, const double *x, const double *y, float *out);
  void (*widen)(uint32_t n, const float *x, double *out);
  /* out += x */
  void (*add_widened)(uint32_t n, const float *x, double *out);
  /* b = (side w - (v - v_last)) + load. Returns true if y or y + b is above -TB_NEAR anywhere. */
  bool (*penetrate)(uint32_t n, float side, const float *w, const double *v, const double *v_last,
                    const double *load, const double *y, double *b);
  /* `start` for the rows of wires, and the laws there: f = f_last + (law - f_last)/(1 + slope
   * yield). Returns the largest change of f. */
  float (*start_newton_diagonal)(uint32_t wires, uint32_t lanes, const TbContactLaw *laws,
                                 TbStartF *start, float *f);
  /* The laws at s = b - p - t (p - p_last), never stored: `trial_at_forces` takes t = 0, and finds
   * `way` and `miss`, too. */
  void (*trial_at_forces)(TbTrial *trial);
  void (*trial_moved)(TbTrial *trial);
  /* `finish` without the sums of the laws. */
  void (*finish_forces)(uint32_t n, const TbEndF *end);
  /* With `firm` = 1 + slope yield: weight = sqrt(slope), f += (law - f)/firm, and x with law +
   * weight x = f. Returns the largest change of f. */
  float (*newton_diagonal)(uint32_t n, const float *law, const float *slope, const float *yield,
                           float *f, float *weight, float *x);
  /* r = -(x + weight (p - before)), d = r; the largest |weight r|/firm and Sum r r. */
  TbResidualF (*newton_residual)(uint32_t n, const float *slope, const float *yield,
                                 const float *weight, const float *x, const float *p,
                                 const float *before, float *r, float *d);
  /* out = f[0] x[0] + f[1] x[1] + ..., with `count` terms */
  void (*sum_scaled)(uint32_t n, uint32_t count, const float *f, const float *const *x, float *out);
  /* The coupling terms of V at q, and its gradient: both [pairs][2], the cosine before the sine. */
  double (*von_karman)(const TbVonKarman *plate, const float *q, float *gradient, float *scratch);
#else
  /* weight = sqrt(slope), r = (s - b) + p, d = -weight r */
  TbResidual (*newton_rhs)(uint32_t n, const double *slope, const double *s, const double *b,
                           const double *p, double *weight, double *d);

  /* ---- the state ---------------------------------------------------------------------------- */

  /* `gemv` and `gemm` with a matrix in single precision, summed in double. */
  void (*gemv_rounded)(uint32_t blocks, uint32_t n, double *out, const float *matrix,
                       const double *x);
  void (*gemm_rounded)(const TbGather *gather);
  /* out = a x - b y */
  void (*two_step)(uint32_t n, double *out, const double *a, const double *x, const double *b,
                   const double *y);
  /* y_h = gain_h q, pull_h = g y_h, along_h = Sum y_h (next + last), own_hl = Sum y_h pull_l;
   * `step_and_stretch` takes the step of all modes with it, next = a q - b last. */
  void (*stretch)(const TbParts *parts, TbStretching *stretching);
  void (*step_and_stretch)(const TbParts *parts, TbStretching *stretching);
  /* Sum pull_h x, of the modes that stretch head h */
  TbPair (*stretch_dots)(const TbParts *parts, const double *const pull[TB_COUPLINGS],
                         const double *x);
  /* next += stretch_0 pull_0 + stretch_1 pull_1, of the heads that a part stretches; then `losses`,
   * and Sum ahead next and Sum behind next. */
  void (*end_modes)(const TbParts *parts, TbModesEnd *end);
  /* next += g (sound.first now + sound.second before) */
  void (*push_by_sound)(const TbParts *parts, TbPair sound, const double *now, const double *before,
                        const double *g, double *next);
  /* Sum ahead q and Sum behind q */
  TbPair (*two_dots_of_parts)(const TbParts *parts, const double *ahead, const double *behind,
                              const double *q);
  /* Sum c |x| */
  double (*weighted_size)(uint32_t n, const double *c, const double *x);
  /* sums[i] = Sum w[i] d^2, d = next - last, for i < count, 2 or 3 */
  void (*losses)(uint32_t n, uint32_t count, const double *const w[3], const double *next,
                 const double *last, double sums[3]);
  /* Sum over 8 lanes i of (Sum_j ahead[j][i] (next - now) + behind[j][i] (last - now))^2, with
   * next, now and last at mode[j], for `count` modes. */
  double (*radiated_power)(uint32_t count, const uint32_t *mode, const double *ahead,
                           const double *behind, const double *next, const double *now,
                           const double *last);
  /* out = x - y */
  void (*subtract)(uint32_t n, const double *x, const double *y, double *out);

  /* One step of the wires (wires.h) without forces, with the coefficients of each wire and v at its
   * `lanes`. v is readable one element before and after. inner is 1 at inner nodes, otherwise 0.
   * `bend` is scratch, readable like v. */
  void (*wire_step)(uint32_t wires, uint32_t lanes, const TbWireCoefficients *c,
                    const double *inner, const double *now, const double *last, double *bend,
                    double *next);
  /* The wires' loss in a step, Sum over wires of loss_0 Sum d^2 + loss_1 Sum (d[i] - d[i-1])^2,
   * d = next - last. */
  double (*wire_losses)(uint32_t wires, uint32_t lanes, const TbWireCoefficients *c,
                        const double *next, const double *last);
  /* out[l] = Sum over wires of f[w][l]. */
  TbWireContacts (*gather_wires)(uint32_t wires, uint32_t lanes, const double *f, const double *s,
                                 double *out);
  /* Returns true if y > 0, y + s > 0 or f != 0 anywhere. */
  bool (*touches)(uint32_t n, const double *y, const double *s, const double *f);
  /* eta = (side w - v) + rest + shift, with the wire's shift; b = (eta - last) + load */
  void (*penetrate)(uint32_t wires, uint32_t lanes, double side, const double *shift,
                    const double *w, const double *v, const double *rest, const double *last,
                    const double *load, double *b);
  /* v += contact_compliance (f - rest), eta = last + s */
  void (*move_wires)(uint32_t n, const double *contact_compliance, const double *f,
                     const double *rest, const double *last, const double *s, double *v,
                     double *eta);
#endif
} TB_TYPE(TbKernels);

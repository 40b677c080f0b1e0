// SPDX-License-Identifier: MIT
/** Gives a canvas a dot for each of the screen's, and empties it. Returns its size [px]. */
export function fitCanvas(canvas) {
  canvas.width = Math.round(canvas.clientWidth * devicePixelRatio);
  canvas.height = Math.round(canvas.clientHeight * devicePixelRatio);
  return { width: canvas.width, height: canvas.height };
}

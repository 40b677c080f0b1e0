// SPDX-License-Identifier: MIT
// Events of an instrument, plain data that may go to another thread: { frame, name, before, after } is a call of the engine with
// arguments before and after the frame of the block; { frame, message } has the bytes of a message of a song.

/** Hands the engine those that are due in the next `frames` frames, of which `frame` is the first, and takes them from the list,
 * which is in order of frames. */
export function send(engine, instrument, events, frame, frames) {
  let due = 0;
  while (due < events.length && events[due].frame < frame + frames) {
    const offset = Math.max(events[due].frame - frame, 0);
    if (!sendOne(engine, instrument, events[due++], offset)) throw new Error("there is not enough memory");
  }
  events.splice(0, due);
}

function sendOne(engine, instrument, { name, before, after, message }, offset) {
  if (!message) return engine[name](instrument, ...before, offset, ...after);
  new Uint8Array(engine.memory.buffer, engine.instrument_message(instrument), message.length).set(message);
  return engine.instrument_send_message(instrument, offset);
}

/* SPDX-License-Identifier: MIT */
/* For programs of WebAssembly under node: clock() is the time of the processor; Emscripten's is that of the wall. */
mergeInto(LibraryManager.library, {
  clock: function () {
    const used = process.cpuUsage(); // [us]
    return used.user + used.system;
  },
});

/* SPDX-License-Identifier: MIT */
#include "window/window_of.h"

#include "window/kit_plugin_window.h"

void *window_of(const PluginWindowShell *shell, const WindowKind **kind) {
  const bool is_kit = shell->instrument->kind->id == INSTRUMENT_KIT;
  *kind = is_kit ? &kit_plugin_window_kind : &plugin_window_kind;
  return is_kit ? (void *)kit_plugin_window_create(shell) : (void *)plugin_window_create(shell);
}

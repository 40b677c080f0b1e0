/* SPDX-License-Identifier: MIT */
/* How a host's browser finds presets: the built-in ones in the plugins, the user's in a folder, if
 * it is there. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clap/instance.h"
#include "clap/presets.h"
#include "drums/user_presets.h"
#include "kit/user_sounds.h"
#include "platform/files.h"

#define MESSAGE (2 * TABOR_TEXT_SIZE)

static const clap_preset_discovery_provider_descriptor_t provider_descriptor = {
  .clap_version = CLAP_VERSION_INIT, .id = "tabor.presets", .name = "Tabor", .vendor = "Tabor"};

typedef struct Provider {
  clap_preset_discovery_provider_t provider;
  const clap_preset_discovery_indexer_t *indexer;
} Provider;

/* ---- places --------------------------------------------------------------------------------- */

static bool find_user_folder(char path[USER_PRESET_PATH]) {
  FileStatus status;
  return user_folder(path) && file_status(path, &status) && status.kind == FILE_KIND_FOLDER;
}

static bool declare_user_folder(const clap_preset_discovery_indexer_t *indexer) {
  static const clap_preset_discovery_filetype_t files = {
    .name = "Tabor drum or kit", .description = "INI file", .file_extension = "ini"};
  char path[USER_PRESET_PATH];
  const clap_preset_discovery_location_t location = {.flags = CLAP_PRESET_DISCOVERY_IS_USER_CONTENT,
                                                     .name = "My drums and kits",
                                                     .kind = CLAP_PRESET_DISCOVERY_LOCATION_FILE,
                                                     .location = path};
  if (!find_user_folder(path)) return true;
  return indexer->declare_filetype(indexer, &files) &&
         indexer->declare_location(indexer, &location);
}

static bool declare(const clap_preset_discovery_provider_t *provider) {
  const Provider *const own = provider->provider_data;
  const clap_preset_discovery_location_t location = {.flags =
                                                       CLAP_PRESET_DISCOVERY_IS_FACTORY_CONTENT,
                                                     .name = "Drums and kits",
                                                     .kind = CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN};
  return own->indexer->declare_location(own->indexer, &location) &&
         declare_user_folder(own->indexer);
}

/* ---- presets -------------------------------------------------------------------------------- */

/* "snare-14x5.5" as "Snare 14x5.5". */
static void readable(const char *name, char *text, size_t size) {
  (void)snprintf(text, size, "%s", name);
  text[0] = (char)toupper((unsigned char)text[0]);
  for (char *dash = text; (dash = strchr(dash, '-')) != NULL;) *dash = ' ';
}

typedef clap_preset_discovery_metadata_receiver_t Receiver;

/* Plugins that a preset is for, and what kind of drum it is. */
static void describe(const Receiver *receiver, bool is_kit, const char *category,
                     const char *comment) {
  static const clap_universal_plugin_id_t drum[] = {{"clap", ID_DRUM}, {"clap", ID_DRUM_MULTI}},
                                          kit = {"clap", ID_KIT};
  if (is_kit) {
    receiver->add_plugin_id(receiver, &kit);
  } else {
    for (int i = 0; i < 2; i++) receiver->add_plugin_id(receiver, &drum[i]);
  }
  if (*comment) receiver->set_description(receiver, comment);
  receiver->add_feature(receiver, CLAP_PLUGIN_FEATURE_DRUM);
  if (*category) receiver->add_feature(receiver, category);
}

static bool describe_built_in(const Receiver *receiver, const TaborPresetInfo *preset,
                              bool is_kit) {
  char name[CLAP_NAME_SIZE];
  readable(preset->name, name, sizeof name);
  if (!receiver->begin_preset(receiver, name, preset->name)) return false;
  receiver->set_flags(receiver, CLAP_PRESET_DISCOVERY_IS_FACTORY_CONTENT);
  describe(receiver, is_kit, preset->category, preset->comment);
  return true;
}

/* Until the host has enough. */
static void describe_all(const Receiver *receiver) {
  bool goes_on = true;
  for (uint32_t i = 0; goes_on && i < tabor_preset_count(); i++) {
    goes_on = describe_built_in(receiver, tabor_preset(i), false);
  }
  for (uint32_t i = 0; goes_on && i < tabor_kit_count(); i++) {
    goes_on = describe_built_in(receiver, tabor_kit(i), true);
  }
}

static bool read_file(const Receiver *receiver, const char *path) {
  UserSound sound;
  char message[MESSAGE];
  if (!user_sound_read(path, &sound, message, sizeof message)) {
    receiver->on_error(receiver, 0, message);
    return false;
  }
  if (receiver->begin_preset(receiver, sound.name, NULL)) {
    receiver->set_flags(receiver, CLAP_PRESET_DISCOVERY_IS_USER_CONTENT);
    describe(receiver, sound.is_kit, sound.category, sound.comment);
  }
  return true;
}

static bool get_metadata(const clap_preset_discovery_provider_t *provider, uint32_t kind,
                         const char *location, const Receiver *receiver) {
  (void)provider;
  if (kind == CLAP_PRESET_DISCOVERY_LOCATION_FILE) return location && read_file(receiver, location);
  if (kind != CLAP_PRESET_DISCOVERY_LOCATION_PLUGIN) return false;
  describe_all(receiver);
  return true;
}

/* ---- the provider --------------------------------------------------------------------------- */

static const void *get_extension(const clap_preset_discovery_provider_t *provider, const char *id) {
  (void)provider;
  (void)id;
  return NULL;
}

static void destroy(const clap_preset_discovery_provider_t *provider) {
  free(provider->provider_data);
}

static uint32_t count(const clap_preset_discovery_factory_t *factory) {
  (void)factory;
  return 1;
}

static const clap_preset_discovery_provider_descriptor_t *
get_descriptor(const clap_preset_discovery_factory_t *factory, uint32_t index) {
  (void)factory;
  return index == 0 ? &provider_descriptor : NULL;
}

static const clap_preset_discovery_provider_t *
create(const clap_preset_discovery_factory_t *factory,
       const clap_preset_discovery_indexer_t *indexer, const char *id) {
  (void)factory;
  if (strcmp(id, provider_descriptor.id) != 0) return NULL;
  Provider *const own = calloc(1, sizeof *own);
  if (!own) return NULL;
  own->indexer = indexer;
  own->provider = (clap_preset_discovery_provider_t){.desc = &provider_descriptor,
                                                     .provider_data = own,
                                                     .init = declare,
                                                     .destroy = destroy,
                                                     .get_metadata = get_metadata,
                                                     .get_extension = get_extension};
  return &own->provider;
}

const clap_preset_discovery_factory_t presets_factory = {
  .count = count, .get_descriptor = get_descriptor, .create = create};

/* SPDX-License-Identifier: MIT */
/* A VST3 host for tests: plays a note of velocity 100 in one of a bundle's plugins, offline, and writes all channels of
   all outputs, interleaved 32-bit floats, to standard output.

   vst3_host BUNDLE PLUGIN FRAME FRAMES BLOCK */
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#ifdef _WIN32
#  include <fcntl.h>
#  include <io.h>
#endif

#include "pluginterfaces/vst/ivstaudioprocessor.h"
#include "public.sdk/source/vst/hosting/eventlist.h"
#include "public.sdk/source/vst/hosting/hostclasses.h"
#include "public.sdk/source/vst/hosting/module.h"
#include "public.sdk/source/vst/hosting/parameterchanges.h"
#include "public.sdk/source/vst/hosting/processdata.h"

using namespace Steinberg;
using namespace Steinberg::Vst;

static const double rate = 48000;

static void require(bool is_so, const char *what) {
  if (is_so) return;
  std::fprintf(stderr, "vst3_host: %s\n", what);
  std::exit(1);
}

static IPtr<IComponent> create(const VST3::Hosting::Module &module, const std::string &name) {
  const auto &factory = module.getFactory();
  for (const auto &info : factory.classInfos()) {
    if (info.name() == name) return factory.createInstance<IComponent>(info.ID());
  }
  return nullptr;
}

static void begin(IComponent *component, IAudioProcessor *processor, int32 block) {
  ProcessSetup setup{kOffline, kSample32, block, rate};
  require(processor->setupProcessing(setup) == kResultOk, "setupProcessing");
  for (int32 i = 0; i < component->getBusCount(kAudio, kOutput); i++) {
    component->activateBus(kAudio, kOutput, i, true);
  }
  component->activateBus(kEvent, kInput, 0, true);
  require(component->setActive(true) == kResultOk, "setActive");
  processor->setProcessing(true);
}

static void add_note(EventList *events, int32 frame) {
  Event event = {};
  event.type = Event::kNoteOnEvent;
  event.sampleOffset = frame;
  event.noteOn.channel = 9;
  event.noteOn.pitch = 38;
  event.noteOn.velocity = 100.0f / 127;
  event.noteOn.noteId = -1;
  events->addEvent(event);
}

static void write_frames(const ProcessData &data) {
  for (int32 frame = 0; frame < data.numSamples; frame++) {
    for (int32 bus = 0; bus < data.numOutputs; bus++) {
      for (int32 i = 0; i < data.outputs[bus].numChannels; i++) {
        std::fwrite(&data.outputs[bus].channelBuffers32[i][frame], sizeof(float), 1, stdout);
      }
    }
  }
}

static void play(IComponent *component, IAudioProcessor *processor, int32 note, int32 frames,
                 int32 block) {
  HostProcessData data;
  EventList events;
  ParameterChanges changes, answers;
  require(data.prepare(*component, block, kSample32), "buffers");
  data.inputEvents = &events;
  data.inputParameterChanges = &changes;
  data.outputParameterChanges = &answers;
  for (int32 at = 0; at < frames; at += data.numSamples) {
    data.numSamples = std::min(block, frames - at);
    events.clear();
    if (note >= at && note < at + data.numSamples) add_note(&events, note - at);
    require(processor->process(data) == kResultOk, "process");
    write_frames(data);
  }
}

int main(int count, char **words) {
#ifdef _WIN32
  _setmode(_fileno(stdout), _O_BINARY);
#endif
  require(count == 6, "usage: vst3_host BUNDLE PLUGIN FRAME FRAMES BLOCK");
  std::string error;
  HostApplication application;
  const int32 block = std::atoi(words[5]);
  const auto module = VST3::Hosting::Module::create(words[1], error);
  require(module != nullptr, error.c_str());
  auto component = create(*module, words[2]);
  require(component && component->initialize(&application) == kResultOk, "there is no such plugin");
  {
    FUnknownPtr<IAudioProcessor> processor(component);
    begin(component, processor, block);
    play(component, processor, std::atoi(words[3]), std::atoi(words[4]), block);
    processor->setProcessing(false);
  }
  component->setActive(false);
  component->terminate();
  return 0;
}

/* SPDX-License-Identifier: MIT */
/*
 * The window of the VST3 plugins on a desktop of its own, in a host with a run loop, as hosts on Linux have, or with that
 * of Windows: size and scale, what is drawn, that a click is a stroke, that controls tell the host, and that nothing stays of a
 * window that is closed, whether its outer window goes first or last. What is drawn is the same as in the CLAP plugins: test_clap_window.
 *
 * test_vst3_window BUNDLE; OPENINGS in the environment is how often a window is opened, PICTURES a folder for pictures of it.
 */
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csetjmp>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <thread>

#ifdef _WIN32
#  include <windows.h>
#endif

extern "C" {
#include <cmocka.h>

#include "desktop.h"
#include "user_files.h"
#include "window_checks.h"
}

#include "pluginterfaces/gui/iplugview.h"
#include "pluginterfaces/gui/iplugviewcontentscalesupport.h"
#include "pluginterfaces/vst/ivstaudioprocessor.h"
#include "pluginterfaces/vst/ivsteditcontroller.h"
#include "public.sdk/source/vst/hosting/eventlist.h"
#include "public.sdk/source/vst/hosting/hostclasses.h"
#include "public.sdk/source/vst/hosting/module.h"
#include "public.sdk/source/vst/hosting/parameterchanges.h"
#include "public.sdk/source/vst/hosting/processdata.h"

using namespace Steinberg;
using namespace Steinberg::Vst;

static const int32 FRAMES = 2400;

static Desktop server;
static VST3::Hosting::Module::Ptr module;
static HostApplication application;

/* ---- a host --------------------------------------------------------------------------------- */

/* Objects of the host live as long as it does, whoever refers to them. */
#define UNCOUNTED                                                                                  \
  uint32 PLUGIN_API addRef() override { return 1; }                                                \
  uint32 PLUGIN_API release() override { return 1; }

#ifdef _WIN32
static const FIDString NATIVE_WINDOW = kPlatformTypeHWND;

/* Timers are messages, which come in time. */
struct Timers : IPlugFrame {
  void *found(const TUID) { return nullptr; }

  void tick() {
    for (int i = 0; i < 5; i++) {
      MSG message;
      std::this_thread::sleep_for(std::chrono::milliseconds(15));
      while (PeekMessageW(&message, nullptr, 0, 0, PM_REMOVE)) DispatchMessageW(&message);
    }
  }
  bool has_none() const { return true; }
};

/* Kits have sounds of files if there is libsndfile. */
static bool has_sound_files() {
  return LoadLibraryW(L"sndfile.dll") || LoadLibraryW(L"libsndfile-1.dll");
}
#else
static const FIDString NATIVE_WINDOW = kPlatformTypeX11EmbedWindowID;

/* Timers act when the test says so. */
struct Timers : IPlugFrame, Linux::IRunLoop {
  std::map<Linux::ITimerHandler *, Linux::TimerInterval> timers;

  void *found(const TUID id) {
    return FUnknownPrivate::iidEqual(id, Linux::IRunLoop::iid) ? static_cast<IRunLoop *>(this)
                                                               : nullptr;
  }

  tresult PLUGIN_API registerEventHandler(Linux::IEventHandler *, Linux::FileDescriptor) override {
    return kResultOk;
  }
  tresult PLUGIN_API unregisterEventHandler(Linux::IEventHandler *) override { return kResultOk; }
  tresult PLUGIN_API registerTimer(Linux::ITimerHandler *handler,
                                   Linux::TimerInterval interval) override {
    timers[handler] = interval;
    return kResultOk;
  }
  tresult PLUGIN_API unregisterTimer(Linux::ITimerHandler *handler) override {
    timers.erase(handler);
    return kResultOk;
  }

  void tick() {
    const auto now = timers; /* one may take away another */
    for (const auto &timer : now) {
      if (timers.count(timer.first)) timer.first->onTimer();
    }
  }
  bool has_none() const { return timers.empty(); }
};

static bool has_sound_files() { return true; }
#endif

struct Frame : Timers {
  ViewRect asked;

  tresult PLUGIN_API queryInterface(const TUID id, void **object) override {
    *object = found(id);
    return *object ? kResultOk : kNoInterface;
  }
  UNCOUNTED

  tresult PLUGIN_API resizeView(IPlugView *, ViewRect *size) override {
    asked = *size;
    return kResultOk;
  }
};

/* Counts what the plugin tells of its controls. */
struct Edits : IComponentHandler {
  int begun = 0, performed = 0, ended = 0;
  ParamValue newest = -1;

  tresult PLUGIN_API queryInterface(const TUID, void **found) override {
    *found = nullptr;
    return kNoInterface;
  }
  UNCOUNTED

  tresult PLUGIN_API beginEdit(ParamID) override {
    begun++;
    return kResultOk;
  }
  tresult PLUGIN_API performEdit(ParamID, ParamValue value) override {
    performed++;
    newest = value;
    return kResultOk;
  }
  tresult PLUGIN_API endEdit(ParamID) override {
    ended++;
    return kResultOk;
  }
  tresult PLUGIN_API restartComponent(int32) override { return kResultOk; }
};

struct Plugin {
  IPtr<IComponent> component;
  FUnknownPtr<IAudioProcessor> processor;
  FUnknownPtr<IEditController> controller;
  HostProcessData data;
  ParameterChanges changes, answers;
  Edits edits;

  explicit Plugin(const char *name)
      : component(create(name)), processor(component), controller(component) {
    ProcessSetup setup{kRealtime, kSample32, FRAMES, 48000};
    assert_true(component->initialize(&application) == kResultOk);
    assert_true(controller->setComponentHandler(&edits) == kResultOk);
    assert_true(processor->setupProcessing(setup) == kResultOk);
    for (int32 i = 0; i < component->getBusCount(kAudio, kOutput); i++) {
      component->activateBus(kAudio, kOutput, i, true);
    }
    assert_true(component->setActive(true) == kResultOk);
    processor->setProcessing(true);
    assert_true(data.prepare(*component, FRAMES, kSample32));
    data.numSamples = FRAMES;
    data.inputParameterChanges = &changes;
    data.outputParameterChanges = &answers;
  }
  ~Plugin() {
    processor->setProcessing(false);
    component->setActive(false);
    controller->setComponentHandler(nullptr);
    component->terminate();
  }

  static IPtr<IComponent> create(const std::string &name) {
    const auto &factory = module->getFactory();
    for (const auto &info : factory.classInfos()) {
      if (info.name() == name) return factory.createInstance<IComponent>(info.ID());
    }
    fail_msg("no plugin %s", name.c_str());
    return nullptr;
  }

  /* Plays a block; the largest sample. */
  double run() {
    double peak = 0;
    answers.clearQueue();
    assert_true(processor->process(data) == kResultOk);
    for (int32 i = 0; i < FRAMES; i++) {
      peak = std::max(peak, std::fabs(double(data.outputs[0].channelBuffers32[0][i])));
    }
    return peak;
  }
};

struct Window {
  Frame frame;
  IPtr<IPlugView> view;
  DesktopWindow outer, inner;

  Window(Plugin &plugin, int scale)
      : view(owned(plugin.controller->createView(ViewType::kEditor))) {
    ViewRect size;
    assert_non_null(view.get());
    assert_true(view->isPlatformTypeSupported(NATIVE_WINDOW) == kResultOk);
    assert_true(view->setFrame(&frame) == kResultOk);
    FUnknownPtr<IPlugViewContentScaleSupport> scaling(view);
    if (scale != 1) assert_true(scaling->setContentScaleFactor(float(scale)) == kResultOk);
    assert_true(view->getSize(&size) == kResultOk);
    assert_int_equal(size.getWidth(), scale * WIDTH);
    assert_int_equal(size.getHeight(), scale * HEIGHT);
    outer = desktop_window(&server, uint16_t(scale * WIDTH), uint16_t(scale * HEIGHT));
    assert_true(view->attached(reinterpret_cast<void *>(uintptr_t(outer)), NATIVE_WINDOW) ==
                kResultOk);
    inner = desktop_inner(&server, outer);
    assert_true(inner != 0);
    frame.tick();
  }
  ~Window() {
    if (view) close();
    desktop_close(&server, outer);
  }

  void close() {
    assert_true(view->removed() == kResultOk);
    view->setFrame(nullptr);
    view = nullptr;
  }

  void point(DesktopAct type, int x, int y) {
    desktop_point(&server, inner, type, type == DESKTOP_MOVE ? DESKTOP_NONE : DESKTOP_LEFT, x, y);
  }
  void click(int x, int y) {
    desktop_click(&server, inner, x, y);
    frame.tick();
  }
};

/* ---- tests ---------------------------------------------------------------------------------- */

static void a_click_is_a_stroke(void **) {
  for (int scale = 1; scale <= 2; scale++) {
    Plugin plugin("Tabor");
    Window window(plugin, scale);
    for (int i = 0; i < 3; i++) { /* the view comes from the audio thread */
      assert_true(plugin.run() == 0);
      window.frame.tick();
    }
    const uint32_t head = desktop_pixel(&server, window.inner, scale * MIDDLE_X, scale * MIDDLE_Y);
    const uint32_t beside = desktop_pixel(&server, window.inner, scale * 5, scale * 5);
    print_message("the head is #%06x, beside it #%06x\n", unsigned(head), unsigned(beside));
    assert_true(head != 0 && head != beside);
    window.click(scale * 5, scale * 5);
    assert_true(plugin.run() == 0);
    window.click(scale * (MIDDLE_X + R / 2), scale * MIDDLE_Y);
    const double peak = plugin.run();
    print_message("a click sounds to %.3f\n", peak);
    assert_true(peak > 1e-3);
    window.frame.tick();
    keep_picture(window.outer, scale == 1 ? "vst3" : "vst3-twice");
  }
}

/* The snare drum of the kit `standard` stands at the lower left. */
static void a_click_strikes_a_drum_of_a_kit(void **) {
  Plugin plugin("Tabor Kit");
  Window window(plugin, 1);
  plugin.run();
  window.frame.tick();
  window.click(5, 5);
  assert_true(plugin.run() == 0);
  window.click(136, 265);
  const double peak = plugin.run();
  print_message("a click on the snare drum sounds to %.3f\n", peak);
  assert_true(peak > 1e-3);
  window.frame.tick();
  keep_picture(window.outer, "vst3-kit");
}

/* The last of all is a kit of the user's, whose hi-hat is a sound file. */
static void a_kit_of_a_file_plays(void **) {
  if (!has_sound_files()) skip();
  Plugin plugin("Tabor Kit");
  Window window(plugin, 1);
  EventList notes;
  Event note{};
  note.type = Event::kNoteOnEvent;
  note.noteOn.pitch = 42;
  note.noteOn.velocity = 1;
  notes.addEvent(note);
  plugin.run();
  window.frame.tick();
  window.click(434, 34);
  double peak = 0;
  for (int i = 0; i < 2000 && peak < 0.1; i++) { /* until it is built; its hi-hat is louder */
    plugin.data.inputEvents = &notes;
    peak = plugin.run();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  print_message("a hi-hat of a file sounds to %.3f\n", peak);
  assert_true(peak > 0.1);
}

static void a_control_tells_the_host(void **) {
  Plugin plugin("Tabor");
  Window window(plugin, 1);
  const int x = CONTROL_X + CONTROL_WIDTH / 2;
  plugin.run();
  window.frame.tick();
  window.point(DESKTOP_PRESS, x, STRAINER_Y);
  window.point(DESKTOP_MOVE, x - CONTROL_WIDTH / 4, STRAINER_Y);
  window.point(DESKTOP_RELEASE, x - CONTROL_WIDTH / 4, STRAINER_Y);
  window.frame.tick();
  plugin.run();
  window.frame.tick();
  print_message("edits: %d begun, %d performed, %d ended, to %.3f\n", plugin.edits.begun,
                plugin.edits.performed, plugin.edits.ended, plugin.edits.newest);
  assert_int_equal(plugin.edits.begun, 1);
  assert_true(plugin.edits.performed >= 1);
  assert_int_equal(plugin.edits.ended, 1);
  assert_true(std::fabs(plugin.edits.newest - 0.25) < 0.01);
}

static void it_has_any_size(void **) {
  Plugin plugin("Tabor");
  Window window(plugin, 1);
  ViewRect size(0, 0, 1080, 660);
  assert_true(window.view->canResize() == kResultOk);
  assert_true(window.view->onSize(&size) == kResultOk);
  window.frame.tick();
  ViewRect now;
  assert_true(window.view->getSize(&now) == kResultOk);
  assert_int_equal(now.getWidth(), 1080);
  assert_int_equal(now.getHeight(), 660);
}

static void nothing_stays_of_a_window(void **) {
  const int openings = std::getenv("OPENINGS") ? std::atoi(std::getenv("OPENINGS")) : 20;
  Plugin plugin("Tabor");
  { Window window(plugin, 1); }
  const long before = open_files();
  for (int i = 0; i < openings; i++) {
    Window window(plugin, 1);
    plugin.run();
    window.frame.tick();
    if (i % 2 == 0) continue;
    assert_true(window.view->removed() == kResultOk); /* as JUCE does it: */
    desktop_close(&server, window.outer);             /* the outer window goes first, */
    window.frame.tick();                              /* timers still act, */
    window.view = nullptr;                            /* then the view goes */
    assert_true(window.frame.has_none());
    window.outer = desktop_window(&server, 10, 10);
  }
  print_message("%d windows: %ld files open before, %ld after\n", openings, before, open_files());
  assert_int_equal(open_files(), before);
}

int main(int count, char **words) {
  std::string error;
  if (count != 2) return 2;
  module = VST3::Hosting::Module::create(words[1], error);
  if (!module) {
    std::fprintf(stderr, "test_vst3_window: %s\n", error.c_str());
    return 1;
  }
  if (!desktop_start(&server)) {
    print_message("SKIPPED: no desktop: needs xvfb\n");
    return 77;
  }
  const CMUnitTest tests[] = {
    cmocka_unit_test(a_click_is_a_stroke),
    cmocka_unit_test(a_click_strikes_a_drum_of_a_kit),
    cmocka_unit_test_setup_teardown(a_kit_of_a_file_plays, user_files_make, user_files_remove),
    cmocka_unit_test(a_control_tells_the_host),
    cmocka_unit_test(it_has_any_size),
    cmocka_unit_test(nothing_stays_of_a_window),
  };
  const int failed = cmocka_run_group_tests(tests, nullptr, nullptr);
  desktop_stop(&server);
  module.reset();
  return failed;
}

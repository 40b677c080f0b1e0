/* SPDX-License-Identifier: MIT */
/**
 * @file tabor.hpp
 * libtabor for C++: objects that clean up after themselves, errors as exceptions. Copy it into your
 * program and change it to taste; it adds nothing that tabor.h has not got.
 */
#ifndef TABOR_EXAMPLES_TABOR_HPP
#define TABOR_EXAMPLES_TABOR_HPP

#include <tabor/tabor.h>

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace tabor {

/** What a set-up function refused, with its key, value and range. */
class Error : public std::runtime_error {
public:
  explicit Error(const TaborError &error) : std::runtime_error(error.message), detail(error) {}
  TaborError detail;
};

/** Throws what @p function(arguments..., &error) refuses. */
template <typename Function, typename... Arguments>
void check(Function function, Arguments... arguments) {
  TaborError error;
  if (function(arguments..., &error) != TABOR_OK) throw Error(error);
}

/** A drum's parameters. */
class Definition : public TaborDrumDef {
public:
  explicit Definition(const std::string &preset) {
    check(tabor_drum_def_preset, static_cast<TaborDrumDef *>(this), preset.c_str());
  }
  void set(const std::string &key, const std::string &value) {
    check(tabor_drum_def_set, static_cast<TaborDrumDef *>(this), key.c_str(), value.c_str());
  }
  /** The stroke that the definition names. */
  TaborEvent stroke() const {
    TaborEvent event{};
    event.type = TABOR_EVENT_STRIKE;
    event.striker = static_cast<uint32_t>(tabor_drum_def_find_striker(this, strike.striker));
    event.velocity = strike.velocity;
    event.radius = strike.radius;
    event.angle = strike.angle;
    return event;
  }
};

/** A counted reference to a model: copies share it. Not for the audio thread. */
class Model {
public:
  explicit Model(const TaborDrumDef &definition, double sample_rate = 48000,
                 TaborQuality quality = TABOR_QUALITY_LIVE) {
    TaborModelOptions options;
    tabor_model_options_default(&options);
    options.sample_rate = sample_rate;
    options.quality = quality;
    TaborModel *model = nullptr;
    check(tabor_model_create, &definition, &options, &model);
    model_.reset(model, tabor_model_release);
  }
  TaborModel *get() const { return model_.get(); }

private:
  std::shared_ptr<TaborModel> model_;
};

/** A sounding drum. */
class Drum {
public:
  explicit Drum(const Model &model) {
    TaborDrum *drum = nullptr;
    check(tabor_drum_create, model.get(), &drum);
    drum_.reset(drum);
  }
  /** Plays @p events and hears the first microphone. Real-time safe. */
  void process(const std::vector<TaborEvent> &events, float *output, uint32_t frames) {
    std::array<float *, TABOR_MAX_MICS> outputs{output};
    tabor_drum_process(drum_.get(), events.data(), static_cast<uint32_t>(events.size()),
                       outputs.data(), frames);
  }
  TaborLedger ledger() const {
    TaborLedger ledger;
    tabor_drum_ledger(drum_.get(), &ledger);
    return ledger;
  }
  /** Everything there is of the drum; load() of a drum on the same model goes on from it. */
  std::vector<std::byte> save() const {
    std::vector<std::byte> bytes(tabor_drum_state_size(drum_.get()));
    tabor_drum_state_save(drum_.get(), bytes.data());
    return bytes;
  }
  void load(const std::vector<std::byte> &bytes) {
    if (tabor_drum_state_load(drum_.get(), bytes.data(), bytes.size()) != TABOR_OK)
      throw std::runtime_error("the saved state is not of this drum's model");
  }

private:
  struct Destroy {
    void operator()(TaborDrum *drum) const { tabor_drum_destroy(drum); }
  };
  std::unique_ptr<TaborDrum, Destroy> drum_;
};

} // namespace tabor

#endif

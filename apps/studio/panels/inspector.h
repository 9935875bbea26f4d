// The parts of the settings.
#pragma once

#include <functional>

#include "desk.h"
#include "panels/fields.h"

namespace studio {

using Walk = std::function<void(sturnus::FieldVisitor&)>;

/// A heading that folds what follows; returns whether that is shown.
bool fold(Desk& desk, const std::string& name, const char* text, bool is_open_at_first);
/// One flock: its terms, limits, hunting, and all else.
void show_flock(Desk& desk, const FieldPlace& where, std::size_t index, const Walk& walk);
/// Named sets for the three main terms.
void show_presets(Desk& desk, std::size_t flock);
/// The unit that is followed, in place of the settings.
void show_tracked(Desk& desk);
/// Keeps the camera at the unit that is followed, and draws what it feels.
void follow_tracked(Desk& desk);

/// Rows for everything that a filter lets through at the top, and all below it.
class Rows : public sturnus::FieldVisitor {
 public:
  using Filter = std::function<bool(std::string_view)>;
  Rows(Desk& desk, FieldPlace where, Filter filter = {})
      : desk_(desk), where_(std::move(where)), filter_(std::move(filter)) {}
  void field(std::string_view key, sturnus::FieldRef place, const sturnus::About& about) override;
  void table(std::string_view key, const sturnus::About& about, const Walk& walk, std::string_view) override;
  void items(std::string_view key, const sturnus::About& about, const sturnus::Items& items) override;

 private:
  void part(const std::string& path, std::string_view title, const sturnus::About& about, const Walk& walk);
  bool shows(std::string_view key) const { return !filter_ || filter_(key); }

  Desk& desk_;
  FieldPlace where_;
  Filter filter_;
};

}  // namespace studio

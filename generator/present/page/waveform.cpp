#include "generator/present/page/waveform.hpp"

#include <fmt/core.h>

#include "generator/present/page/chart.hpp"

namespace mixcmp::page {
namespace {

/// Places in the picture of waves.
constexpr double names_width = 160, cycle_width = 31, between_windows = 22;
constexpr double rows_top = 30, row_pitch = 30, row_height = 18;

double width_of(const WaveWindow& window) {
  return cycle_width * static_cast<double>(window.last - window.first + 1);
}

/// Draws the signals of one window.
class WindowPicture {
public:
  WindowPicture(Element& picture, const WaveWindow& window, double x)
      : picture_(picture), window_(window), x_(x) {}

  void add_row(const WaveRow& row, double y) {
    std::visit([&](const auto& signal) { add(signal, y); }, row.signal);
  }

  void add_numbers(std::uint64_t cycle_zero) {
    for (std::uint64_t cycle = window_.first; cycle <= window_.last; ++cycle) {
      const auto number = static_cast<std::int64_t>(cycle) - static_cast<std::int64_t>(cycle_zero);
      picture_.add(text_at(x_of(cycle) + cycle_width / 2, rows_top - 12, "tick middle",
                           fmt::format("{}", number)));
    }
  }

private:
  double x_of(std::uint64_t cycle) const {
    return x_ + cycle_width * static_cast<double>(cycle - window_.first);
  }

  void add(const WaveClock& /*clock*/, double y) {
    Path path;
    path.move_to(x_, y + row_height);
    for (std::uint64_t cycle = window_.first; cycle <= window_.last; ++cycle) {
      const double x = x_of(cycle);
      path.line_to(x, y + row_height).line_to(x, y).line_to(x + cycle_width / 2, y);
      path.line_to(x + cycle_width / 2, y + row_height).line_to(x + cycle_width, y + row_height);
    }
    picture_.add(path.element("signal"));
  }

  void add(const WaveBit& bit, double y) {
    constexpr double slope = 3;
    Path path;
    for (std::uint64_t cycle = window_.first; cycle <= window_.last; ++cycle) {
      const double level = bit.high.contains(cycle) ? y : y + row_height;
      const double x = x_of(cycle);
      if (cycle == window_.first) path.move_to(x, level);
      path.line_to(x + slope, level).line_to(x + cycle_width, level);
    }
    picture_.add(path.element("signal"));
  }

  void add(const WaveBus& bus, double y) {
    for (std::uint64_t cycle = window_.first; cycle <= window_.last; ++cycle) {
      const auto beat = bus.beats.find(cycle);
      if (beat == bus.beats.end()) {
        add_idle(cycle, y);
      } else {
        add_beat(cycle, beat->second, y);
      }
    }
  }

  void add_idle(std::uint64_t cycle, double y) {
    const double x = x_of(cycle), middle = y + row_height / 2;
    picture_.add(Path().move_to(x, middle).line_to(x + cycle_width, middle).element("idle"));
  }

  void add_beat(std::uint64_t cycle, const WaveBeat& beat, double y) {
    constexpr double corner = 4;
    const double x = x_of(cycle), middle = y + row_height / 2;
    const double x1 = x + corner, x2 = x + cycle_width - corner;
    const double lower = y + row_height;
    Path outline;
    outline.move_to(x, middle).line_to(x1, y).line_to(x2, y).line_to(x + cycle_width, middle);
    outline.line_to(x2, lower).line_to(x1, lower).close();
    const std::string style = beat.color < 0 ? "beat" : "beat " + color_class(beat.color);
    Element group("g", {{"class", "point"}});
    group.add(tip(beat.tip));
    group.add(outline.element(style));
    group.add(text_at(x + cycle_width / 2, middle + 4, "beattext middle", beat.text));
    picture_.add(group);
  }

  Element& picture_;
  const WaveWindow& window_;
  double x_;
};

}  // namespace

Element draw(const Waveform& waveform) {
  double width = names_width;
  for (const WaveWindow& window : waveform.windows) width += width_of(window) + between_windows;
  const double all = rows_top + row_pitch * static_cast<double>(waveform.rows.size());
  Element picture("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                          {"class", "chart wave"},
                          {"viewBox", fmt::format("0 0 {} {}", width, all)},
                          {"style", fmt::format("width:{}px", width)},
                          {"role", "group"},
                          {"tabindex", "0"},
                          {"aria-label", waveform.title}});
  picture.add(text_at(names_width - 14, rows_top - 12, "tick end", "cycle"));
  for (std::size_t row = 0; row < waveform.rows.size(); ++row) {
    const double y = rows_top + row_pitch * static_cast<double>(row);
    picture.add(text_at(names_width - 14, y + 13, "label end", waveform.rows[row].name));
  }
  double x = names_width;
  for (const WaveWindow& window : waveform.windows) {
    if (x > names_width) {
      const double middle = x - between_windows / 2;
      picture.add(Path().move_to(middle, 8).line_to(middle, all - 6).element("break"));
    }
    WindowPicture part(picture, window, x);
    part.add_numbers(waveform.cycle_zero);
    for (std::size_t row = 0; row < waveform.rows.size(); ++row) {
      part.add_row(waveform.rows[row], rows_top + row_pitch * static_cast<double>(row));
    }
    x += width_of(window) + between_windows;
  }
  Element whole("div", {{"class", "picture wide"}});
  Element scrolling("div", {{"class", "scroll"}});
  return whole.add(scrolling.add(picture));
}

}  // namespace mixcmp::page

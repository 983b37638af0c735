#include "generator/present/page/axis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace mixcmp::page {
namespace {

/// 1, 2 or 5 times a power of ten: at most `most` of it make `length`.
double round_step(double length, int most) {
  const double least = length / most;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

/// "10⁻³", or "1" and "10" for the powers 0 and 1.
std::string power_of_ten(int exponent) {
  constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  if (exponent == 0) return "1";
  if (exponent == 1) return "10";
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digits[c - '0'];
  return text;
}

/// The fraction of a logarithmic axis that lies below its lowest power of ten, for the line of 0.
constexpr double zero_share = 0.09;

}  // namespace

Axis::Axis(const AxisSpec& spec, const std::vector<double>& values, double from, double to)
    : scaling_(spec.scaling), from_(from), to_(to) {
  if (scaling_ == Scaling::logarithmic) {
    choose_logarithmic(values);
    return;
  }
  double low = 0, high = 1;
  if (!values.empty()) {
    low = *std::min_element(values.begin(), values.end());
    high = *std::max_element(values.begin(), values.end());
  }
  if (spec.begins_at_zero && low >= 0) low = 0;
  choose_linear(low, high, spec.least_step);
}

void Axis::choose_linear(double low, double high, double least_step) {
  constexpr int most_ticks = 10;
  if (high <= low) high = low + 1;
  const double step = std::max(least_step, round_step(high - low, most_ticks));
  low_ = std::floor(low / step + 1e-9) * step;
  high_ = std::ceil(high / step - 1e-9) * step;
  const auto count = static_cast<int>(std::lround((high_ - low_) / step));
  for (int k = 0; k <= count; ++k) {
    const double value = low_ + k * step;
    ticks_.push_back({value, fmt::format("{:.6g}", std::abs(value) < step / 2 ? 0 : value)});
  }
}

void Axis::choose_logarithmic(const std::vector<double>& values) {
  double low = 0, high = 0;
  for (const double value : values) {
    if (value <= 0) {
      has_zero_ = true;
      continue;
    }
    low = low == 0 ? value : std::min(low, value);
    high = std::max(high, value);
  }
  if (high == 0) low = high = 1;
  if (has_zero_) ticks_.push_back({0, "none"});
  constexpr double most_decades_with_parts = 2.5;
  if (std::log10(high / low) <= most_decades_with_parts) {
    add_parts_of_decades(low, high);
  } else {
    add_decades(low, high);
  }
}

void Axis::add_decades(double low, double high) {
  low_ = std::floor(std::log10(low) + 1e-9);
  high_ = std::ceil(std::log10(high) - 1e-9);
  const int step = std::max(1, static_cast<int>(std::ceil((high_ - low_) / 8)));
  for (int k = static_cast<int>(low_); k <= static_cast<int>(high_); k += step) {
    ticks_.push_back({std::pow(10, k), power_of_ten(k)});
  }
}

/// Adds ticks at 1, 2 and 5 times powers of ten.
void Axis::add_parts_of_decades(double low, double high) {
  const auto first = static_cast<int>(std::floor(std::log10(low)));
  const auto last = static_cast<int>(std::floor(std::log10(high)));
  std::vector<double> parts;
  for (int k = first; k <= last + 1; ++k) {
    for (const int part : {1, 2, 5}) parts.push_back(part * std::pow(10, k));
  }
  while (parts[1] <= low * (1 + 1e-9)) parts.erase(parts.begin());
  while (parts[parts.size() - 2] >= high * (1 - 1e-9) && parts.size() > 2) parts.pop_back();
  for (const double part : parts) ticks_.push_back({part, fmt::format("{:.6g}", part)});
  low_ = std::log10(parts.front());
  high_ = std::log10(parts.back());
}

double Axis::position(double value) const {
  double share = 0;
  if (scaling_ == Scaling::linear) {
    share = (value - low_) / (high_ - low_);
  } else if (value > 0) {
    const double below = has_zero_ ? zero_share : 0;
    share = below + (1 - below) * (std::log10(value) - low_) / (high_ - low_);
  }
  return from_ + share * (to_ - from_);
}

}  // namespace mixcmp::page

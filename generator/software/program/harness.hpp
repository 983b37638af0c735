namespace {

/// An allocator of whole cache lines, so that the vectors of a run begin at one.
template <class Real>
struct CacheLines {
  using value_type = Real;
  static constexpr std::align_val_t line{64};

  CacheLines() = default;
  template <class Other>
  CacheLines(const CacheLines<Other>&) {}

  Real* allocate(std::size_t count) {
    return static_cast<Real*>(::operator new(count * sizeof(Real), line));
  }
  void deallocate(Real* values, std::size_t) { ::operator delete(values, line); }
  bool operator==(const CacheLines&) const { return true; }
};

template <class Real>
using Column = std::vector<Real, CacheLines<Real>>;
using Columns = std::vector<Column<double>>;

[[noreturn]] void fail(const char* message) {
  std::fprintf(stderr, "%s\n", message);
  std::exit(1);
}

/// The data of a run. Items i and items j are the same if both are of one table. If a comparison is
/// a row, the rows are items j.
struct Data {
  std::uint64_t first_items = 0, second_items = 0;
  Columns columns;
};

std::uint64_t read_word(std::ifstream& file) {
  std::uint64_t word = 0;
  file.read(reinterpret_cast<char*>(&word), sizeof word);
  return word;
}

/// Reads a file of 64-bit words: the numbers of items, then each column's length and doubles.
Data read_data(const char* path) {
  std::ifstream file(path, std::ios::binary);
  Data data{read_word(file), read_word(file), Columns(file_columns)};
  for (Column<double>& column : data.columns) {
    const std::uint64_t length = read_word(file);
    if (!file) break;
    column.resize(length);
    file.read(reinterpret_cast<char*>(column.data()),
              static_cast<std::streamsize>(length * sizeof(double)));
  }
  if (!file) fail("the data file cannot be read");
  return data;
}

bool passes(const Check& check, double operand) {
  const auto bits = std::bit_cast<std::uint64_t>(operand);
  const bool negative = (bits >> 63) != 0;
  if ((check.sign == 1 && negative) || (check.sign == 2 && !negative)) return false;
  if (check.shift == 0) return true;
  const std::uint64_t leading = (bits & ~(std::uint64_t{1} << 63)) >> check.shift;
  return check.least <= leading && leading <= check.greatest;
}

/// Rounds an operand to float. If that is exceptional the result is NaN, which leaves the
/// comparison undecided.
float rounded(double operand) {
  const float nearest = static_cast<float>(operand);
  const bool tiny = std::fabs(nearest) <= std::numeric_limits<float>::min();
  const bool exceptional =
      !std::isfinite(nearest) || (tiny && static_cast<double>(nearest) != operand);
  return exceptional ? std::numeric_limits<float>::quiet_NaN() : nearest;
}

/// One column per input, rounded for one filter. An operand that fails a check becomes a NaN.
template <class Filter>
std::vector<Column<float>> rounded_columns(const Columns& columns) {
  std::vector<Column<float>> inputs;
  for (const std::size_t column : column_of_input) {
    Column<float>& values = inputs.emplace_back();
    for (const double operand : columns[column]) values.push_back(rounded(operand));
  }
  for (const Check& check : Filter::checks) {
    const Column<double>& operands = columns[column_of_input[check.input]];
    for (std::size_t k = 0; k < operands.size(); ++k) {
      if (passes(check, operands[k])) continue;
      inputs[check.input][k] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  return inputs;
}

template <class Real>
std::vector<const Real*> pointers(const std::vector<Column<Real>>& columns) {
  std::vector<const Real*> result;
  for (const Column<Real>& column : columns) result.push_back(column.data());
  return result;
}

struct Tally {
  std::uint64_t less = 0, equal = 0, greater = 0, unordered = 0, recomputed = 0;

  void add(const Tally& other) {
    less += other.less;
    equal += other.equal;
    greater += other.greater;
    unordered += other.unordered;
    recomputed += other.recomputed;
  }
};

/// Comparisons [first, end) with item i, or rows [first, end) if a comparison is a row; at most
/// longest_run.
struct Run {
  std::size_t i, first, end;
  std::size_t size() const { return end - first; }
};
/// The longest run for which four columns of doubles fit into the first-level cache.
constexpr std::size_t longest_run = 1024;

template <class Kernel>
[[gnu::noinline]] std::uint64_t count_equal(const double* const* columns, Run run) {
  const Kernel compare{columns, run.i};
  std::uint64_t equal = 0;
  for (std::size_t j = run.first; j < run.end; ++j) {
    compare(j, [&](bool, bool is_equal, bool) { equal += is_equal; });
  }
  return equal;
}

/// Counts the verdicts of a run. It is never inlined, so all operations that raise floating-point
/// flags are over when it returns. Equal comparisons are counted in a second pass, and only if some
/// are neither less nor greater.
template <class Kernel>
[[gnu::noinline]] Tally count_orders(const double* const* columns, Run run) {
  const Kernel compare{columns, run.i};
  std::uint64_t less = 0, greater = 0;
  for (std::size_t j = run.first; j < run.end; ++j) {
    compare(j, [&](bool is_less, bool, bool is_greater) {
      less += is_less;
      greater += is_greater;
    });
  }
  const std::uint64_t rest = run.size() - less - greater;
  const std::uint64_t equal = rest == 0 ? 0 : count_equal<Kernel>(columns, run);
  return {less, equal, greater, rest - equal, 0};
}

template <class Filter>
[[gnu::noinline]] Tally count_decided(const float* const* columns, Run run) {
  const Filter decide{columns, run.i};
  std::uint32_t less = 0, greater = 0;
  for (std::size_t j = run.first; j < run.end; ++j) {
    decide(j, [&](bool is_less, bool is_greater) {
      less += is_less;
      greater += is_greater;
    });
  }
  return {less, 0, greater, 0, 0};
}

/// Sets open[k] to 1 if comparison run.first + k is undecided, else to 0.
template <class Filter>
[[gnu::noinline]] void mark_open(const float* const* columns, Run run, std::uint32_t* open) {
  const Filter decide{columns, run.i};
  for (std::size_t j = run.first; j < run.end; ++j) {
    decide(j,
           [&](bool is_less, bool is_greater) { open[j - run.first] = !(is_less | is_greater); });
  }
}

constexpr int exceptional_flags = FE_UNDERFLOW | FE_OVERFLOW | FE_DIVBYZERO | FE_INVALID;

class Comparison {
public:
  explicit Comparison(const Columns& columns) {
    for (const std::size_t column : column_of_input) inputs_.push_back(columns[column].data());
  }
  Tally operator()(Run run) const { return count_orders<Doubles>(inputs_.data(), run); }

private:
  std::vector<const double*> inputs_;
};

/// Compares in floats if they decide, else in doubles. Floating-point flags are sticky, so one look
/// after a run tells whether any operation in it was exceptional. If one was, doubles compute the
/// whole run.
template <class Filter>
class FilteredComparison {
public:
  static constexpr const char* name = Filter::name;

  explicit FilteredComparison(const Columns& columns)
      : exact_(columns), rounded_(rounded_columns<Filter>(columns)), inputs_(pointers(rounded_)) {}

  Tally operator()(Run run) const {
    Tally tally = count_decided<Filter>(inputs_.data(), run);
    if (std::fetestexcept(exceptional_flags) != 0) return recompute_all(run);
    if (tally.less + tally.greater != run.size()) recompute_open(run, tally);
    return tally;
  }

private:
  Tally recompute_all(Run run) const {
    Tally tally = exact_(run);
    tally.recomputed = run.size();
    std::feclearexcept(exceptional_flags);
    return tally;
  }

  void recompute_open(Run run, Tally& tally) const {
    std::array<std::uint32_t, longest_run> open;
    mark_open<Filter>(inputs_.data(), run, open.data());
    std::array<std::uint32_t, longest_run> list;
    std::size_t count = 0;
    for (std::uint32_t k = 0; k < run.size(); ++k) {
      list[count] = k;
      count += open[k];
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t j = run.first + list[k];
      tally.add(exact_({run.i, j, j + 1}));
    }
    tally.recomputed += count;
    std::feclearexcept(exceptional_flags);
  }

  Comparison exact_;
  std::vector<Column<float>> rounded_;
  std::vector<const float*> inputs_;
};

/// The least j that item i meets.
constexpr std::size_t first_partner(std::size_t i) {
  return form == Form::all_pairs ? i + 1 : 0;
}

/// Divides the data's comparisons into units of some ten thousand to some millions, which threads
/// share. A unit is one run of items j with each of some thousand items i, or some runs of rows.
class Work {
public:
  explicit Work(const Data& data)
      : first_items_(data.first_items),
        items_(data.second_items),
        tiles_((items_ + tile - 1) / tile),
        chunks_(form == Form::rows ? 1 : (first_items_ + chunk - 1) / chunk) {}

  std::uint64_t units() const { return std::uint64_t{tiles_} * chunks_; }

  template <class Visit>
  void visit(std::uint64_t unit, Visit visit_run) const {
    const std::size_t first = unit / chunks_ * tile;
    const std::size_t end = std::min(first + tile, items_);
    if constexpr (form == Form::rows) {
      for (std::size_t j = first; j < end; j += longest_run) {
        visit_run(Run{0, j, std::min(j + longest_run, end)});
      }
    } else {
      const std::size_t begin = unit % chunks_ * chunk;
      for (std::size_t i = begin; i < std::min(begin + chunk, first_items_); ++i) {
        if (const Run run{i, std::max(first, first_partner(i)), end}; run.first < run.end) {
          visit_run(run);
        }
      }
    }
  }

private:
  static constexpr std::size_t tile = form == Form::rows ? 64 * longest_run : longest_run;
  static constexpr std::size_t chunk = 4096;

  std::size_t first_items_, items_, tiles_, chunks_;
};

struct Measured {
  std::uint64_t comparisons = 0;
  double seconds = 0, processor_seconds = 0;
};

double processor_time() {
  timespec time = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The work of one thread, which takes units until the time is over.
template <class Kernel>
void take_units(const Kernel& kernel, const Work& work, std::atomic<std::uint64_t>& next,
                double seconds, Measured& measured) {
  Tally tally;
  std::feclearexcept(exceptional_flags);
  const double processor_start = processor_time();
  const auto start = std::chrono::steady_clock::now();
  do {
    work.visit(next++ % work.units(), [&](Run run) { tally.add(kernel(run)); });
    measured.seconds = seconds_since(start);
  } while (measured.seconds < seconds);
  measured.processor_seconds = processor_time() - processor_start;
  measured.comparisons = tally.less + tally.equal + tally.greater + tally.unordered;
}

template <class Kernel>
void measure(const char* name, const Kernel& kernel, const Work& work, unsigned threads,
             double seconds) {
  std::atomic<std::uint64_t> next = 0;
  std::vector<Measured> parts(threads);
  std::vector<std::thread> others;
  for (unsigned k = 1; k < threads; ++k) {
    others.emplace_back([&, k] { take_units(kernel, work, next, seconds, parts[k]); });
  }
  take_units(kernel, work, next, seconds, parts[0]);
  for (std::thread& other : others) other.join();
  double per_second = 0, share = 0;
  for (const Measured& part : parts) {
    per_second += static_cast<double>(part.comparisons) / part.processor_seconds;
    share += part.processor_seconds / part.seconds / threads;
  }
  std::printf("rate %s %u %.6e %.4f\n", name, threads, per_second, share);
}

/// Makes each comparison once, on all threads together, and prints the counts.
template <class Kernel>
void tally(const char* name, const Kernel& kernel, const Work& work, unsigned threads) {
  std::atomic<std::uint64_t> next = 0;
  std::vector<Tally> parts(threads);
  std::vector<std::thread> others;
  const auto run_part = [&](Tally& part) {
    std::feclearexcept(exceptional_flags);
    for (std::uint64_t unit; (unit = next++) < work.units();) {
      work.visit(unit, [&](Run run) { part.add(kernel(run)); });
    }
  };
  for (unsigned k = 1; k < threads; ++k) others.emplace_back([&, k] { run_part(parts[k]); });
  run_part(parts[0]);
  for (std::thread& other : others) other.join();
  Tally all;
  for (const Tally& part : parts) all.add(part);
  const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
  std::printf("tally %s %llu %llu %llu %llu %llu\n", name, number(all.less), number(all.equal),
              number(all.greater), number(all.unordered), number(all.recomputed));
}

/// Prints one letter per comparison, in order: <, =, >, u; ? if the filter did not decide.
template <class Kernel>
void print_verdicts(const char* name, const Kernel& kernel, const Data& data) {
  std::string letters;
  std::feclearexcept(exceptional_flags);
  const auto add = [&](Run run) {
    const Tally one = kernel(run);
    letters += one.recomputed ? '?' : one.less ? '<' : one.equal ? '=' : one.greater ? '>' : 'u';
  };
  const std::size_t first_items = form == Form::rows ? 1 : data.first_items;
  for (std::size_t i = 0; i < first_items; ++i) {
    for (std::size_t j = first_partner(i); j < data.second_items; ++j) add({i, j, j + 1});
  }
  std::printf("verdicts %s %s\n", name, letters.c_str());
}

/// Checks the facts that the filters' proofs rest on: gradual underflow, rounding to nearest, and
/// flags that only inexact underflow and overflow raise.
bool arithmetic_is_ieee() {
  volatile float smallest = std::numeric_limits<float>::min(), one = 1;
  std::feclearexcept(FE_ALL_EXCEPT);
  volatile float half = smallest * 0.5f;
  const bool gradual = half + half == smallest && std::fetestexcept(FE_UNDERFLOW) == 0;
  const bool nearest = one + 0x1.8p-24f == 1 + 0x1p-23f && one + 0x1p-24f == 1;
  volatile float inexact = smallest * 0.3f;
  const bool underflow = std::fetestexcept(FE_UNDERFLOW) != 0;
  volatile float overflowed = std::numeric_limits<float>::max() * (one + one);
  const bool overflow = std::fetestexcept(FE_OVERFLOW) != 0;
  std::feclearexcept(FE_ALL_EXCEPT);
  return gradual && nearest && underflow && overflow && inexact > 0 && std::isinf(overflowed);
}

template <class... Each>
std::tuple<FilteredComparison<Each>...> filtered(const Columns& columns, std::tuple<Each...>) {
  return {FilteredComparison<Each>(columns)...};
}

/// The comparison in double, then one for each filter.
class Kernels {
public:
  explicit Kernels(const Columns& columns)
      : exact_(columns), filtered_(filtered(columns, Filters())) {}

  template <class Use>
  void for_each(Use use) const {
    use("double", exact_);
    std::apply([&](const auto&... each) { (use(each.name, each), ...); }, filtered_);
  }

private:
  Comparison exact_;
  decltype(filtered(std::declval<const Columns&>(), Filters())) filtered_;
};

/// Prints the last line, which says that nothing is missing.
int end() {
  const bool printed = std::printf("end\n") > 0 && std::fflush(stdout) == 0;
  if (!printed || std::ferror(stdout) != 0) fail("the results cannot be written");
  return 0;
}

}  // namespace

/// program DATA verdicts: prints the verdict of every comparison, for small data.
/// program DATA measure THREADS ROUNDS SECONDS: prints tallies, then rates with one thread and with
/// all. The kernels take turns, so that a disturbance affects all of them.
int main(int argc, char** argv) {
  if (argc < 3) fail("DATA verdicts, or DATA measure THREADS ROUNDS SECONDS");
  if (!arithmetic_is_ieee()) fail("floating-point arithmetic is not that of IEEE 754");
  const Data data = read_data(argv[1]);
  const Work work(data);
  const bool measures = std::strcmp(argv[2], "measure") == 0 && argc == 6;
  const unsigned threads = measures ? static_cast<unsigned>(std::atoi(argv[3])) : 1;
  const Kernels kernels(data.columns);
  kernels.for_each(
      [&](const char* name, const auto& kernel) { tally(name, kernel, work, threads); });
  if (!measures) {
    kernels.for_each(
        [&](const char* name, const auto& kernel) { print_verdicts(name, kernel, data); });
    return end();
  }
  for (int round = 0; round < std::atoi(argv[4]); ++round) {
    kernels.for_each([&](const char* name, const auto& kernel) {
      measure(name, kernel, work, 1, std::atof(argv[5]));
      if (threads > 1) measure(name, kernel, work, threads, std::atof(argv[5]));
    });
  }
  return end();
}

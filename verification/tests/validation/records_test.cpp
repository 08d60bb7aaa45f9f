// SPDX-License-Identifier: MIT
/// The readers on files written here, and the estimators on records with known answers.

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <random>

#include "stickslip/data/input_error.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"
#include "validation/models.hpp"

namespace stickslip::testing {
namespace {

using validation::Figure;
using validation::Record;

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::string element(std::uint32_t type, const std::string& data) {
  const auto size = static_cast<std::uint32_t>(data.size());
  return bytes_of<std::uint32_t>({type, size}) + data + std::string((8 - size % 8) % 8, '\0');
}

// A matrix of doubles with flags, dimensions and a name, which has the short form up to four letters.
std::string array(const std::string& name, const std::vector<double>& values) {
  const auto rows = static_cast<std::int32_t>(values.size());
  const std::uint32_t tag = static_cast<std::uint32_t>(name.size()) << 16U | 1U;
  const std::string named = name.size() > 4
                                ? element(1, name)
                                : bytes_of<std::uint32_t>({tag}) + name + std::string(4 - name.size(), '\0');
  return element(14, element(6, bytes_of<std::uint32_t>({6, 0})) +
                         element(5, bytes_of<std::int32_t>({rows, 1})) + named +
                         element(9, bytes_of(values)));
}

std::string compressed(const std::string& data) {
  auto size = ::compressBound(data.size());
  std::string packed(size, '\0');
  ::compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(data.data()),
             data.size());
  return bytes_of<std::uint32_t>({15, static_cast<std::uint32_t>(size)}) + packed.substr(0, size);
}

std::string mat_header() { return "MATLAB 5.0 MAT-file" + std::string(105, ' ') + std::string("\0\1IM", 4); }

class MeasuredRecords : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& bytes) const {
    return folder_.write("a", bytes);
  }

  const InputFolder folder_;
};

STICKSLIP_VERIFIES(MeasuredRecords, "K1");
TEST_F(MeasuredRecords, OfMatFilesMayBeCompressed) {
  const std::vector<double> t{0.0, 0.5, 1.0}, x{0.25, -1e-300, 3e7};
  const auto arrays =
      validation::read_mat(file(mat_header() + compressed(array("t", t)) + array("Fnorm", x)));
  EXPECT_EQ(arrays.at("t"), t);
  EXPECT_EQ(arrays.at("Fnorm"), x);
}

TEST_F(MeasuredRecords, DamagedFilesAreRefused) {
  const std::string whole = mat_header() + compressed(array("t", {1.0, 2.0, 3.0}));
  for (const std::string& bytes : {whole.substr(0, whole.size() - 4),
                                   mat_header() + array("t", {1.0}).substr(0, 60), std::string("MATLAB 7.3")})
    EXPECT_THROW((void)validation::read_mat(file(bytes)), data::InputError);
  EXPECT_THROW((void)validation::read_slider_record(file(whole)), data::InputError);  // no force
  EXPECT_THROW((void)validation::read_damper_record(file(R"({"data": [[0, "x", 1]]})")), data::InputError);
  EXPECT_THROW((void)validation::read_spectrum(file("X_Value\tlevel\n1 2\n0 3\n")), data::InputError);
}

TEST_F(MeasuredRecords, DamperFileInInchesAndKips) {
  const auto packed = folder_.path() / "f.json.gz";
  const std::string text = R"({"data": [[0, 1, 2, 0, 0, 0], [0.5, -1, 0.001, 0, 0, 0]]})";
  const gzFile stream = ::gzopen(packed.c_str(), "wb");
  ::gzwrite(stream, text.data(), static_cast<unsigned>(text.size()));
  ::gzclose(stream);
  const Record record = validation::read_damper_record(packed);
  EXPECT_EQ(record.time, (std::vector{0.0, 0.5}));
  EXPECT_DOUBLE_EQ(record.displacement[1], -0.0254);
  EXPECT_NEAR(record.force[0], 2000.0 * 0.45359237 * 9.80665, 1e-5);  // two kips
}

// Four resonances in noise, and a line of the mains that is higher than one of them.
TEST_F(MeasuredRecords, SpectrumOfAStrip) {
  const auto exact = validation::strip_frequencies({.modulus = 180e9});
  std::mt19937 random(1);
  std::string text = "LabVIEW Measurement\nX_Dimension\tTime\nDelta_X\t0.1\nX_Value\tlevel\tComment\n";
  for (int i = 0; i < 4000; ++i) {
    const double f = 0.1 * i;
    double level = std::abs(f - 180.0) < 0.05 ? 1.0 : 1e-4 * (1.0 + 1e-9 * static_cast<double>(random()));
    for (const auto& [quantity, hz] : exact) level += 1e-3 / std::hypot(1.0 - f / hz, 1e-3);
    text += std::to_string(f) + "\t" + std::to_string(20.0 * std::log10(level)) + "\n";
  }
  const auto figures = validation::read_strip(validation::read_spectrum(file(text)));
  for (const auto& [quantity, hz] : exact) {
    EXPECT_NEAR(figures.at(quantity).value, hz, 0.0501) << quantity;
    EXPECT_NEAR(figures.at(quantity).uncertainty, 0.1 / std::sqrt(12.0), 1e-9);
  }
}

struct SliderMotion {
  validation::Slider slider;
  double excess{};  // mu_s - mu_k
  [[nodiscard]] double exact(const char* quantity) const {
    return validation::rigid_slider(slider, 0.3, excess).at(quantity);
  }
};

// Samples at 2 kHz with noise, a slow drift of five ranges, impulses, and one sample in a hundred missing.
Record disturbed(const SliderMotion& motion, double duration, double noise) {
  std::mt19937 random(42);
  std::normal_distribution<double> normal(0.0, noise);
  Record record;
  for (int i = 0; i < static_cast<int>(2000.0 * duration); ++i) {
    const double t = 5e-4 * i, impulse = i % 997 == 0 ? 2.0 : 0.0;
    const double drift = 2.5 * motion.exact("force_range") * std::sin(2.0 * std::numbers::pi * t / duration);
    if (i % 100 == 57) continue;
    record.time.push_back(t);
    record.force.push_back(validation::rigid_slider_force(motion.slider, 0.3, motion.excess, t) + drift +
                           impulse + normal(random));
  }
  return record;
}

constexpr SliderMotion slow{{.stiffness = 168.0, .speed = 42e-6}, 0.02};
constexpr SliderMotion fast{{.stiffness = 1002.0, .speed = 4300e-6}, 0.03};

void expect_within(const Figure& figure, double exact, double relative) {
  EXPECT_NEAR(figure.value, exact, 3.0 * figure.uncertainty);
  EXPECT_LT(figure.uncertainty, relative * std::abs(exact));
}

STICKSLIP_VERIFIES(CycleEstimators, "K1");
TEST(CycleEstimators, NoiseWithoutImpulsesAndSignal) {
  EXPECT_NEAR(validation::noise_of(disturbed(slow, 20.0, 1e-3).force), 1e-3, 4e-5);
}

// The width of the median rounds the maxima of the fast motion by up to 1 - cos(pi/12) of the amplitude.
TEST(CycleEstimators, FiguresOfNoisyStickSlip) {
  for (const SliderMotion& motion : {slow, fast}) {
    const double range = motion.exact("force_range");
    const Record record = disturbed(motion, 40.0 * motion.exact("period"), 0.01 * range);
    const validation::Figures figures = validation::read_slider(record, motion.slider);
    for (const char* quantity : {"period", "fall_time"})
      expect_within(figures.at(quantity), motion.exact(quantity), 0.05);
    EXPECT_NEAR(figures.at("force_range").value, range, 0.1 * range);
  }
}

TEST(CycleEstimators, GapsLeaveNoLongCycle) {
  Record record = disturbed(slow, 40.0 * slow.exact("period"), 1e-4);
  const auto begin = record.time.begin() + 8000, end = begin + 4000;
  record.force.erase(record.force.begin() + 8000, record.force.begin() + 12000);
  record.time.erase(begin, end);
  const Figure period = validation::read_slider(record, slow.slider).at("period");
  EXPECT_NEAR(period.value, slow.exact("period"), 3.0 * period.uncertainty);
  EXPECT_LT(period.uncertainty, 0.01 * slow.exact("period"));
}

TEST(CycleEstimators, FindTheFundamental) {
  Record record;
  for (int i = 0; i < 8000; ++i) {
    const double t = 5e-4 * i, phase = 2.0 * std::numbers::pi * t / 0.0293;
    record.time.push_back(t);
    record.force.push_back(0.1 * std::cos(phase) + 0.3 * std::cos(2.0 * phase) + 0.5 * t);
  }
  expect_within(validation::period_by_autocorrelation(record, 0.0348), 0.0293, 1e-3);
}

TEST(CycleEstimators, UncertaintyCoversADrift) {
  std::vector<double> values(800);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = i < 400 ? 1.0 : 2.0;
  EXPECT_GT(validation::mean_of(values, 0.0).uncertainty,
            0.15);  // of 800 independent values it would be 0.018
  EXPECT_TRUE(std::isinf(validation::mean_of(std::vector{1.0}, 0.0).uncertainty));
}

}  // namespace
}  // namespace stickslip::testing

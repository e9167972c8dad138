// The error of quantised soft state is bounded, whatever the chunk; and a chunk fits a datagram.

#include "idl/wire/soft_quantizer.h"

#include <gtest/gtest.h>

#include <random>

#include "idl/wire/bit_stream.h"
#include "idl/wire/codec.h"

namespace prosector {
namespace {

SoftState random_chunk(std::mt19937_64& random, std::size_t count, double size, double place, double speed) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&](double scale) {
    return Vec3(scale * Vec3(unit(random), unit(random), unit(random)));
  };
  SoftState m;
  const Vec3 center = vector(place);
  for (std::size_t i = 0; i < count; ++i) {
    m.positions.push_back(center + vector(size / 2));
    m.velocities.push_back(vector(speed));
  }
  return m;
}

TEST(SoftQuantizer, ErrorIsWithinHalfAQuantum) {
  std::mt19937_64 random(1);
  for (const double size : {0.0, 1e-7, 4e-5, 6e-5, 0.01, 0.1, 1.0, 10.0, 900.0})
    for (const double place : {0.0, 1.0, 90.0})
      for (const double speed : {0.0, 1e-6, 1e-3, 0.01, 0.1, 10.0, 900.0})
        for (const std::size_t count : {1u, 2u, 112u, 256u}) {
          const SoftState sent = random_chunk(random, count, size, place, speed);
          Message message;
          std::size_t bytes = 0;
          ASSERT_FALSE(through_the_wire(sent, message, bytes));
          const auto& got = std::get<SoftState>(message);
          ASSERT_EQ(got.positions.size(), count);
          Vec3 low = sent.velocities[0], high = low;
          for (const Vec3& v : sent.velocities) low = low.cwiseMin(v), high = high.cwiseMax(v);
          const double velocity_error =
              std::max(velocity_quantum, (high - low).maxCoeff() / 255) / 2 * 1.001 + 1e-6 * speed;
          for (std::size_t i = 0; i < count; ++i) {
            EXPECT_LE((got.positions[i] - sent.positions[i]).cwiseAbs().maxCoeff(),
                      position_quantum / 2 + 1e-12);
            EXPECT_LE((got.velocities[i] - sent.velocities[i]).cwiseAbs().maxCoeff(), velocity_error);
          }
        }
}

TEST(SoftQuantizer, AnOutlierWidensTheBox) {
  std::mt19937_64 random(2);
  SoftState sent = random_chunk(random, soft_chunk_points, 0.1, 1, 1);
  sent.positions[17] = {50, -3, 7};
  Message message;
  std::size_t bytes = 0;
  ASSERT_FALSE(through_the_wire(sent, message, bytes));
  const auto& got = std::get<SoftState>(message);
  for (std::size_t i = 0; i < sent.positions.size(); ++i)
    EXPECT_LE((got.positions[i] - sent.positions[i]).cwiseAbs().maxCoeff(), position_quantum / 2 + 1e-12);
}

TEST(SoftQuantizer, AChunkFitsADatagram) {
  std::mt19937_64 random(3);
  static_assert(soft_chunk_points <= max_chunk_points);
  for (const double size : {0.05, 0.25, 1.0, 1.9}) {
    Message message;
    std::size_t bytes = 0;
    ASSERT_FALSE(through_the_wire(random_chunk(random, soft_chunk_points, size, 1, 5), message, bytes));
    EXPECT_LE(bytes, 1120u);  // and 80 for the headers of RTPS
  }
}

TEST(SoftQuantizer, SlowAndNarrowChunksAreSmall) {
  std::mt19937_64 random(5);
  const auto bytes_of = [&](double size, double speed) {
    Message message;
    std::size_t bytes = 0;
    EXPECT_FALSE(through_the_wire(random_chunk(random, soft_chunk_points, size, 0.1, speed), message, bytes));
    return bytes;
  };
  EXPECT_LE(bytes_of(2e-5, 1e-3), 100u);  // one value for all: headers only
  EXPECT_LE(bytes_of(0.003, 0.01), 100u + soft_chunk_points * 3 * (7 + 3) / 8);
  EXPECT_LE(bytes_of(0.03, 0.1), 100u + soft_chunk_points * 3 * (10 + 6) / 8);
}

TEST(BitStream, NumbersOfAllWidthsComeBack) {
  std::mt19937_64 random(4);
  std::vector<std::pair<std::uint32_t, unsigned>> numbers;
  std::size_t bits = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto width = static_cast<unsigned>(random() % 33);
    numbers.emplace_back(static_cast<std::uint32_t>(random() & ((std::uint64_t{1} << width) - 1)), width);
    bits += width;
  }
  std::vector<std::uint8_t> bytes((bits + 7) / 8);
  BitWriter writer(bytes);
  for (const auto& [value, width] : numbers) writer.put(value, width);
  BitReader reader(bytes);
  for (const auto& [value, width] : numbers) EXPECT_EQ(reader.get(width), value);
}

}  // namespace
}  // namespace prosector

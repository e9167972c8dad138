// Mutated serialised bytes through Cyclone's deserialiser and the edge, as a hostile datagram would come.

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <gtest/gtest.h>

#include <random>

#include "common/error.h"
#include "idl/dds/node.h"
#include "idl/dds/qos.h"
#include "idl/wire/codec.h"
#include "tests/dds_domains.h"
#include "tests/idl/samples.h"

namespace prosector {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes serialised(const ddsi_serdata& data) {
  Bytes bytes(ddsi_serdata_size(&data));
  ddsi_serdata_to_ser(&data, 0, bytes.size(), bytes.data());
  return bytes;
}

Bytes mutated(Bytes bytes, std::mt19937_64& random) {
  const std::size_t header = 4;  // representation and options
  switch (random() % 4) {
    case 0:
      bytes.resize(header + random() % (bytes.size() - header));
      break;
    case 1:
      for (std::size_t i = header; i < std::min<std::size_t>(bytes.size(), 4096); ++i)
        bytes[i] = static_cast<std::uint8_t>(random());
      break;
    case 2: {  // a length or a number with an extreme value
      const std::size_t at = header + 4 * (random() % ((bytes.size() - header) / 4));
      const std::uint32_t extreme[] = {0xffffffff, 0x7fffffff, 0x80000000, 0x7fc00000, 0x00ffffff, 0};
      std::memcpy(bytes.data() + at, &extreme[random() % 6], 4);
      break;
    }
    default:
      for (int i = 0; i < 4; ++i)
        bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1 << random() % 8);
  }
  bytes.resize((bytes.size() + 3) / 4 * 4);  // the network hands over whole words
  return bytes;
}

/// True when the bytes made it into a message.
bool receive(const ddsi_sertype* type, const Bytes& bytes, std::size_t topic) {
  const ddsrt_iovec_t part{const_cast<std::uint8_t*>(bytes.data()), bytes.size()};
  ddsi_serdata* data = ddsi_serdata_from_ser_iov(type, SDK_DATA, 1, &part, bytes.size());
  if (data == nullptr) return false;
  const dds_topic_descriptor_t* descriptor = wire_codec(topic).descriptor;
  void* sample = dds_alloc(descriptor->m_size);
  Message message;
  const bool accepted =
      ddsi_serdata_to_sample(data, sample, nullptr, nullptr) && !wire_codec(topic).decode(sample, message);
  dds_sample_free(sample, descriptor, DDS_FREE_ALL);
  ddsi_serdata_unref(data);
  return accepted;
}

void fuzz(dds_entity_t participant, const Message& valid, std::mt19937_64& random) {
  const std::size_t index = valid.index();
  const WireCodec& codec = wire_codec(index);
  const Entity topic(dds_create_topic(participant, codec.descriptor, topics[index].name, nullptr, nullptr),
                     "topic");
  TopicSpec spec = topics[index];
  spec.reliable = spec.transient_local = true;
  const Entity reader(dds_create_reader(participant, topic.get(), endpoint_qos(spec).get(), nullptr),
                      "reader");
  const Entity writer(dds_create_writer(participant, topic.get(), endpoint_qos(spec).get(), nullptr),
                      "writer");
  WireArena arena;
  void* sample = nullptr;
  ASSERT_FALSE(codec.encode(valid, arena, sample));
  ASSERT_EQ(dds_write(writer.get(), sample), DDS_RETCODE_OK);
  ddsi_serdata* data = nullptr;
  dds_sample_info_t info;
  ASSERT_EQ(dds_takecdr(reader.get(), &data, 1, &info, DDS_ANY_STATE), 1);
  const Bytes bytes = serialised(*data);
  EXPECT_EQ((4 + codec.payload_bytes(sample) + 3) / 4 * 4, bytes.size()) << spec.name;
  EXPECT_TRUE(receive(data->type, bytes, index)) << spec.name;
  int refused = 0;
  for (int round = 0; round < 500; ++round) refused += !receive(data->type, mutated(bytes, random), index);
  EXPECT_GT(refused, 0) << spec.name;
  ddsi_serdata_unref(data);
}

TEST(Fuzz, MutatedSerialisedBytes) {
  BusConfig config;
  config.domain = test::dds_domain::cdr_fuzz;
  const Node node(config);
  std::mt19937_64 random(2);
  for (const Message& message : sample_messages()) fuzz(node.participant.get(), message, random);
}

}  // namespace
}  // namespace prosector

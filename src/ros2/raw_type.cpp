// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/raw_type.hpp"

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <dds/ddsi/q_radmin.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

#include "io/bags/message_source.hpp"

namespace surefoot::ros2 {
namespace {

struct Type : ddsi_sertype {
  mutable std::atomic<std::uint64_t> arrived{0};
};

struct Sample : ddsi_serdata {
  RawSample raw;
  std::uint32_t size = 0;  ///< a multiple of 4, which the protocol sends
};

Sample* of(ddsi_serdata* sample) { return static_cast<Sample*>(sample); }
const Sample* of(const ddsi_serdata* sample) { return static_cast<const Sample*>(sample); }

/// Null where there is no memory for it: Cyclone passes over the sample then.
std::unique_ptr<Sample> make_sample(const ddsi_sertype* type, ddsi_serdata_kind kind,
                                    std::size_t size) try {
  constexpr std::size_t kUnit = 4;
  if (size > io::kMostMessageBytes) return nullptr;
  auto sample = std::make_unique<Sample>();
  ddsi_serdata_init(sample.get(), type, kind);
  sample->raw.bytes.resize((size + kUnit - 1) / kUnit * kUnit);
  sample->size = static_cast<std::uint32_t>(sample->raw.bytes.size());
  return sample;
} catch (const std::bad_alloc&) {
  return nullptr;
}

void stamp(RawSample& raw) {
  using std::chrono::system_clock;
  raw.received = std::chrono::steady_clock::now();
  raw.arrival_ns =
      std::chrono::duration_cast<std::chrono::nanoseconds>(system_clock::now().time_since_epoch())
          .count();
}

/// Its bytes are there: now.
Sample* arrived(std::unique_ptr<Sample> sample) {
  stamp(sample->raw);
  if (sample->kind == SDK_DATA) ++static_cast<const Type*>(sample->type)->arrived;
  return sample.release();
}

ddsi_serdata* from_fragments(const ddsi_sertype* type, ddsi_serdata_kind kind,
                             const nn_rdata* fragment, std::size_t size) {
  std::unique_ptr<Sample> sample = make_sample(type, kind, size);
  if (!sample) return nullptr;
  std::size_t filled = 0;
  for (; fragment != nullptr; fragment = fragment->nextfrag) {
    const std::size_t end = std::min<std::size_t>(fragment->maxp1, size);
    if (end <= filled || fragment->min > filled) continue;  // fragments may overlap
    const unsigned char* const bytes =
        NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment));
    std::memcpy(sample->raw.bytes.data() + filled, bytes + (filled - fragment->min), end - filled);
    filled = end;
  }
  return arrived(std::move(sample));
}

ddsi_serdata* from_buffers(const ddsi_sertype* type, ddsi_serdata_kind kind,
                           ddsrt_msg_iovlen_t count, const ddsrt_iovec_t* buffers,
                           std::size_t size) {
  std::unique_ptr<Sample> sample = make_sample(type, kind, size);
  if (!sample) return nullptr;
  std::size_t filled = 0;
  for (ddsrt_msg_iovlen_t i = 0; i < count && filled < size; ++i) {
    const std::size_t part = std::min<std::size_t>(buffers[i].iov_len, size - filled);
    std::memcpy(sample->raw.bytes.data() + filled, buffers[i].iov_base, part);
    filled += part;
  }
  return arrived(std::move(sample));
}

// There is no key, and there are no samples in an application's own layout.
bool same_key(const ddsi_serdata*, const ddsi_serdata*) { return true; }
ddsi_serdata* from_key_hash(const ddsi_sertype* type, const ddsi_keyhash*) {
  return make_sample(type, SDK_KEY, 0).release();
}
ddsi_serdata* from_sample(const ddsi_sertype* type, ddsi_serdata_kind kind, const void*) {
  return kind == SDK_KEY ? make_sample(type, kind, 0).release() : nullptr;
}
bool to_sample(const ddsi_serdata*, void*, void**, void*) { return false; }
ddsi_serdata* to_untyped(const ddsi_serdata* sample) {
  ddsi_serdata* const untyped = make_sample(sample->type, SDK_KEY, 0).release();
  if (untyped != nullptr) untyped->type = nullptr;
  return untyped;
}
bool untyped_to_sample(const ddsi_sertype*, const ddsi_serdata*, void*, void**, void*) {
  return true;
}
void key_hash(const ddsi_serdata*, ddsi_keyhash* hash, bool) {
  std::memset(hash, 0, sizeof(*hash));
}

std::uint32_t size_of_sample(const ddsi_serdata* sample) { return of(sample)->size; }
void copy_bytes(const ddsi_serdata* sample, std::size_t from, std::size_t size, void* to) {
  std::memcpy(to, of(sample)->raw.bytes.data() + from, size);
}
ddsi_serdata* lend_bytes(const ddsi_serdata* sample, std::size_t from, std::size_t size,
                         ddsrt_iovec_t* bytes) {
  bytes->iov_base = const_cast<std::byte*>(of(sample)->raw.bytes.data()) + from;
  bytes->iov_len = size;
  return ddsi_serdata_ref(sample);
}
void give_back_bytes(ddsi_serdata* sample, const ddsrt_iovec_t*) { ddsi_serdata_unref(sample); }
void free_sample(ddsi_serdata* sample) { delete of(sample); }
std::size_t print_sample(const ddsi_sertype*, const ddsi_serdata*, char* text, std::size_t size) {
  if (size > 0) text[0] = '\0';
  return 0;
}

ddsi_serdata_ops sample_functions() {
  ddsi_serdata_ops ops = {};
  ops.eqkey = same_key;
  ops.get_size = size_of_sample;
  ops.from_ser = from_fragments;
  ops.from_ser_iov = from_buffers;
  ops.from_keyhash = from_key_hash;
  ops.from_sample = from_sample;
  ops.to_ser = copy_bytes;
  ops.to_ser_ref = lend_bytes;
  ops.to_ser_unref = give_back_bytes;
  ops.to_sample = to_sample;
  ops.to_untyped = to_untyped;
  ops.untyped_to_sample = untyped_to_sample;
  ops.free = free_sample;
  ops.print = print_sample;
  ops.get_keyhash = key_hash;
  return ops;
}
const ddsi_serdata_ops kSampleFunctions = sample_functions();

void free_type(ddsi_sertype* type) {
  ddsi_sertype_fini(type);
  delete static_cast<Type*>(type);
}
void zero_samples(const ddsi_sertype*, void*, std::size_t) {}
void resize_samples(void** samples, const ddsi_sertype*, void*, std::size_t, std::size_t count) {
  std::fill(samples, samples + count, nullptr);
}
void free_samples(const ddsi_sertype*, void**, std::size_t, dds_free_op_t) {}
bool same_type(const ddsi_sertype*, const ddsi_sertype*) { return true; }  // if the names are
std::uint32_t hash_of_type(const ddsi_sertype*) { return 0; }
ddsi_sertype_ops type_functions() {
  ddsi_sertype_ops ops = {};
  ops.version = ddsi_sertype_v0;
  ops.free = free_type;
  ops.zero_samples = zero_samples;
  ops.realloc_samples = resize_samples;
  ops.free_samples = free_samples;
  ops.equal = same_type;
  ops.hash = hash_of_type;
  return ops;
}
const ddsi_sertype_ops kTypeFunctions = type_functions();

}  // namespace

ddsi_sertype* make_raw_type(const std::string& name) {
  auto type = std::make_unique<Type>();
  ddsi_sertype_init_flags(type.get(), name.c_str(), &kTypeFunctions, &kSampleFunctions,
                          DDSI_SERTYPE_FLAG_TOPICKIND_NO_KEY);
  type->allowed_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1;
  return type.release();
}

std::uint64_t arrived_samples(const ddsi_sertype* type) {
  return static_cast<const Type*>(type)->arrived;
}

ddsi_serdata* make_raw_sample(const ddsi_sertype* type, std::string_view cdr) {
  std::unique_ptr<Sample> sample = make_sample(type, SDK_DATA, cdr.size());
  if (!sample) throw std::bad_alloc();
  std::memcpy(sample->raw.bytes.data(), cdr.data(), cdr.size());
  return sample.release();
}

RawSample copy_raw_sample(const ddsi_serdata* sample) {
  RawSample raw = of(sample)->raw;
  if (raw.arrival_ns == 0) stamp(raw);  // it was written in this process
  return raw;
}

}  // namespace surefoot::ros2

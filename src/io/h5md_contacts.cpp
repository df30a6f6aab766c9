// SPDX-License-Identifier: BSD-3-Clause
#include "src/io/h5md_contacts.hpp"

#include <algorithm>
#include <string>

#include "src/io/growing_dataset.hpp"

namespace bagnold::io {

namespace {

constexpr char const* contacts_group = "/contacts";

std::string contacts_at(char const* name) { return std::string(contacts_group) + "/" + name; }

std::vector<double> numbers_of_each(FrameContacts const& contacts, double FrameContact::*field) {
  std::vector<double> values;
  for (auto const& one : contacts) values.push_back(one.*field);
  return values;
}

std::vector<double> vectors_of_each(FrameContacts const& contacts,
                                    std::array<double, 2> FrameContact::*field) {
  std::vector<double> values;
  for (auto const& one : contacts) values.insert(values.end(), {(one.*field)[0], (one.*field)[1]});
  return values;
}

}  // namespace

H5mdContacts::H5mdContacts(Handle const& file, hsize_t contact_count)
    : count_(-1, H5Dclose),
      pair_(-1, H5Dclose),
      overlap_(-1, H5Dclose),
      normal_(-1, H5Dclose),
      velocity_(-1, H5Dclose),
      elastic_(-1, H5Dclose),
      dissipative_(-1, H5Dclose),
      age_(-1, H5Dclose) {
  auto const creation = without_times(H5P_GROUP_CREATE);
  Handle const group(
      H5Gcreate2(file.get(), contacts_group, H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Gclose);
  require_written(group.valid(), file);
  auto const rows = std::max<hsize_t>(contact_count, 64);
  auto const make = [&](char const* name, Shape const& row) {
    return make_growing(file, contacts_at(name), H5T_IEEE_F64LE, row, rows);
  };
  count_ = make_growing(file, contacts_at("count"), H5T_STD_I64LE, {}, 1024);
  pair_ = make_growing(file, contacts_at("pair"), H5T_STD_I32LE, {2}, rows);
  overlap_ = make("overlap", {});
  normal_ = make("normal", {2});
  velocity_ = make("velocity", {2});
  elastic_ = make("elastic_force", {});
  dissipative_ = make("dissipative_force", {2});
  age_ = make("age", {});
}

void H5mdContacts::append(FrameContacts const& contacts) {
  auto const count = static_cast<std::int64_t>(contacts.size());
  append_rows(count_, H5T_NATIVE_INT64, &count, 1);
  std::vector<std::int32_t> pairs;
  for (auto const& one : contacts)
    pairs.insert(pairs.end(), {static_cast<std::int32_t>(one.i), static_cast<std::int32_t>(one.j)});
  append_rows(pair_, H5T_NATIVE_INT32, pairs.data(), contacts.size());
  auto const put = [&](Handle const& set, auto field) {
    append_rows(set, H5T_NATIVE_DOUBLE, numbers_of_each(contacts, field).data(), contacts.size());
  };
  auto const put_vectors = [&](Handle const& set, auto field) {
    append_rows(set, H5T_NATIVE_DOUBLE, vectors_of_each(contacts, field).data(), contacts.size());
  };
  put(overlap_, &FrameContact::overlap);
  put_vectors(normal_, &FrameContact::normal);
  put_vectors(velocity_, &FrameContact::velocity);
  put(elastic_, &FrameContact::elastic_force);
  put_vectors(dissipative_, &FrameContact::dissipative_force);
  put(age_, &FrameContact::age);
}

void H5mdContacts::close() {
  for (Handle* set :
       {&count_, &pair_, &overlap_, &normal_, &velocity_, &elastic_, &dissipative_, &age_})
    require_written(set->close(), *set);
}

bool has_contacts(Handle const& file) {
  return H5Lexists(file.get(), contacts_group, H5P_DEFAULT) > 0;
}

FrameContacts H5mdContactsReader::next() {
  auto const count = static_cast<hsize_t>(
      read_rows<std::int64_t>(file_, contacts_at("count"), H5T_NATIVE_INT64, frame_++, 1).front());
  auto const doubles = [&](char const* name) {
    return read_rows<double>(file_, contacts_at(name), H5T_NATIVE_DOUBLE, first_, count);
  };
  auto const pair =
      read_rows<std::int32_t>(file_, contacts_at("pair"), H5T_NATIVE_INT32, first_, count);
  auto const overlap = doubles("overlap"), normal = doubles("normal");
  auto const velocity = doubles("velocity"), elastic = doubles("elastic_force");
  auto const dissipative = doubles("dissipative_force"), age = doubles("age");
  FrameContacts contacts;
  for (std::size_t k = 0; k < count; ++k)
    contacts.push_back({static_cast<std::uint32_t>(pair[2 * k]),
                        static_cast<std::uint32_t>(pair[2 * k + 1]),
                        overlap[k],
                        {normal[2 * k], normal[2 * k + 1]},
                        {velocity[2 * k], velocity[2 * k + 1]},
                        elastic[k],
                        {dissipative[2 * k], dissipative[2 * k + 1]},
                        age[k]});
  first_ += count;
  return contacts;
}

}  // namespace bagnold::io

// Translation between the two forms that ROS 2 has for services on DDS.
//
// | | request | response |
// |---|---|---|
// | header form, rmw_cyclonedds | CDR: header {client 8 bytes, number 8 bytes}, then the message | the same header, then the message |
// | inline form, rmw_fastrtps | CDR of the message; inline QoS names the client's response reader | CDR of the message; inline QoS names that reader, and the sequence number of the request's sample |
//
// libddsc has no interface for inline QoS. So all samples of this process have the header form, those that go to a
// participant of Fast DDS are rewritten in the datagram, and of those that come from one the inline QoS is remembered
// until a reader takes the sample. The format of datagrams is a standard, unlike the library's structs.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/sink.hpp"
#include "rtps/announcements.hpp"
#include "rtps/message.hpp"
#include "rtps/recent_map.hpp"

namespace tfloom::rtps {

// The header of a request and of its response.
struct ServiceHeader {
  std::array<std::uint8_t, 8> client{};
  std::int64_t number = 0;

  static constexpr std::size_t size = 16;
  bool operator==(const ServiceHeader&) const = default;  // not <=>, as of Address
  bool operator<(const ServiceHeader& other) const {
    return client != other.client ? client < other.client : number < other.number;
  }
};

// Append the header's bytes: little-endian, whatever the message's encapsulation is.
void append(std::vector<std::byte>& out, const ServiceHeader& header);

// Whether a participant uses the inline form: whether it runs on Fast DDS, by the vendor in its GUIDs.
inline bool uses_inline_form(const GuidPrefix& participant) { return is_of_fast_dds(participant); }
inline bool uses_inline_form(const Gid& gid) { return uses_inline_form(prefix_of(gid)); }

// A sample to which another one is related, as inline QoS names it: by a GUID and a sequence number.
struct Related {
  Gid gid{};
  std::uint64_t sequence_number = 0;
};

// How many clients and servers of other participants are remembered.
constexpr std::size_t max_clients = 65'536;

// Let the heartbeats of a datagram request acknowledgements from all readers that receive them.
void request_acknowledgements(std::span<std::byte> datagram);

class ServiceForms;

// A client or a server of a service: a writer and a reader of this process.
class ServiceEnd {
 public:
  ~ServiceEnd();
  ServiceEnd(const ServiceEnd&) = delete;
  ServiceEnd& operator=(const ServiceEnd&) = delete;

  // Return the header of a sample that the reader has taken from a writer in inline form, or nullopt if the sample is
  // not for this end: another client's response. Samples of one writer are passed in their order.
  std::optional<ServiceHeader> take_header(const Gid& writer, std::int64_t source_stamp_ns);

  // Keep a copy of a sample in header form until `release`: fragments of it can be rewritten only with the whole.
  void keep(std::vector<std::byte> sample);
  void release();
  void release_last();  // of those kept, which was not sent
  [[nodiscard]] std::size_t kept_size() const;  // [bytes]

 private:
  friend class ServiceForms;

  struct Kept {
    std::vector<std::byte> sample;
    std::uint64_t sequence_number = 0;  // 0: no fragment of it was sent
  };
  struct Arrival {
    std::int64_t source_stamp_ns = 0;
    ServiceHeader header;
  };
  using Arrivals = std::map<std::uint64_t, Arrival>;  // by the sequence number of the sample

  ServiceEnd(ServiceForms& forms, bool is_client, std::string service, const Gid& writer, const Gid& reader,
             const std::array<std::uint8_t, 8>& client);

  const std::vector<std::byte>* kept_sample(const Data& fragment);

  ServiceForms& forms_;
  const bool is_client_;
  const std::string service_;
  const Gid writer_;
  const Gid reader_;
  const std::array<std::uint8_t, 8> client_;  // of a client: in its headers
  // The rest is guarded by the mutex of `forms_`.
  std::map<std::uint64_t, std::int64_t> request_numbers_;  // of a client: those of its headers, by sequence number
  RecentMap<Gid, Arrivals> responses_{max_clients};        // of a client: by the server's writer
  RecentMap<Gid, std::uint64_t> last_taken_{max_clients};  // of a server: the sequence number, by the client's writer
  std::deque<Kept> kept_;
  std::size_t kept_size_ = 0;
};

// All clients and servers of this process. Its functions may be called by any thread, and call nothing else: libddsc
// sends and receives while it holds locks.
class ServiceForms {
 public:
  ServiceForms();

  // Return the object of this process; a forked child has a separate one.
  static ServiceForms& of_process();

  // In a forked child: leave the parent's object as it is, because one of the parent's threads may have locked it.
  void abandon() { is_abandoned_ = true; }

  // Register a client, whose requests carry `client` in their headers.
  std::shared_ptr<ServiceEnd> add_client(const std::string& service, const Gid& writer, const Gid& reader,
                                         const std::array<std::uint8_t, 8>& client);
  // Register a server.
  std::shared_ptr<ServiceEnd> add_server(const std::string& service, const Gid& writer, const Gid& reader);

  // Store what a received datagram has about participants, and services in inline form. Return its size [bytes], which
  // grows where heartbeats are inserted; `buffer` begins with its `size` bytes.
  //
  // libddsc drops the samples of a writer that it has just matched until a heartbeat arrives, and those of another vendor's
  // writer that the first heartbeat counts, too. Fast DDS sends one every 3 s, or with each tenth sample, so the first
  // requests and responses would be lost. Until a reader has taken a sample of a writer, heartbeats before its samples
  // state where they begin, and request those that were dropped before; `rewrite` changes an acknowledgement that
  // requests nothing into one that requests the first of these.
  std::size_t receive(std::span<std::byte> buffer, std::size_t size);

  // Rewrite a datagram for an address whose participant uses the inline form. Return false if it can be sent as it is;
  // otherwise `rewritten` holds the datagrams to send instead, none if nothing of it is for that address.
  bool rewrite(const Address& address, Bytes datagram, std::vector<std::vector<std::byte>>& rewritten);

  // Return whether a participant that uses the inline form receives at an address. Costs a comparison where there is no
  // such participant.
  [[nodiscard]] bool is_of_inline_peer(const Address& address);

  // Return whether a participant that uses the inline form receives discovery at an address, or may: a multicast group.
  [[nodiscard]] bool discovers(const Address& address);

  // Announce a reader's content filter from its next announcement on, in place of an earlier one.
  void set_content_filter(const Gid& reader, ContentFilter filter);

  // Announce none any more: the reader is closed.
  void clear_content_filter(const Gid& reader);

  // Return a datagram of discovery with what libddsc's announcements lack, or nullopt if it can be sent as it is.
  std::optional<std::vector<std::byte>> complete(Bytes datagram);

  // Return whether there are clients or servers, whose datagrams are to be rewritten.
  [[nodiscard]] bool has_ends() const { return has_ends_; }

  // Return the endpoint that awaits the responses to a client of the inline form, by the key in the headers of its
  // requests; nullopt for other clients.
  [[nodiscard]] std::optional<Gid> inline_client(const std::array<std::uint8_t, 8>& key);

  // Forget what is remembered of a participant that has left, except its samples that have not been taken yet, because
  // a reader may still hold them.
  void forget(const GuidPrefix& participant);

  // Return how much is remembered of other participants: writers, clients and their keys.
  [[nodiscard]] std::size_t remembered();

  // Return whether the addresses of a participant are known, so that samples for it are rewritten.
  [[nodiscard]] bool knows(const GuidPrefix& participant);

  // From here on, read also the versions that participants announce, of any vendor. Only commands call it, because it
  // costs time.
  void read_versions() { reads_versions_ = true; }

  // Return the version of a participant that was announced since `read_versions`; empty if none was.
  [[nodiscard]] std::string version_of(const GuidPrefix& participant);

 private:
  friend class ServiceEnd;

  // A writer in inline form.
  struct Beginning {
    std::uint64_t first = 0;  // the first sequence number that has arrived; 0: none
    bool is_taken = false;    // whether a reader has taken a sample
  };
  // A heartbeat to be inserted in a received datagram.
  struct Heartbeat {
    std::size_t at = 0;  // offset in the datagram
    EntityId reader{};
    EntityId writer{};
    std::uint64_t first = 0;
    std::uint64_t last = 0;
  };
  // A writer of requests in inline form.
  struct Requests {
    std::string service;  // empty until a server has taken one
    ServiceEnd::Arrivals arrivals;
  };

  void remove(ServiceEnd& end);
  std::optional<ServiceHeader> take_header(ServiceEnd& end, const Gid& writer, std::int64_t source_stamp_ns);
  void insert_heartbeats(const Gid& writer, const Submessage& submessage, std::size_t at,
                         std::vector<Heartbeat>& inserted);
  void note_arrival(const Gid& writer, std::uint64_t sequence_number, std::int64_t source_stamp_ns,
                    const Related& related);
  void note_request(const Gid& writer, const Gid& client, std::uint64_t sequence_number,
                    std::int64_t source_stamp_ns);
  void forget_taken(const Gid& writer, Requests& requests);
  void forget_oldest_requests();
  std::array<std::uint8_t, 8> key_of(const Gid& client);
  ServiceEnd* end_of(const EntityId& writer, const GuidPrefix& participant);
  bool append_request(const GuidPrefix& participant, const Submessage& acknack, std::vector<std::byte>& out) const;
  bool append_rewritten(ServiceEnd& end, const GuidPrefix& participant, const Submessage& submessage, const Data& data,
                        std::vector<std::byte>& out);
  std::optional<Related> related_to(const ServiceEnd& end, const GuidPrefix& participant,
                                    const ServiceHeader& header) const;

  std::atomic<bool> is_abandoned_ = false;
  std::mutex mutex_;
  // The rest is guarded by mutex_, except the flags.
  Addresses addresses_;
  Addresses discovery_addresses_{Addresses::Traffic::discovery};
  Versions versions_;
  std::atomic<bool> reads_versions_ = false;
  std::atomic<bool> has_ends_ = false;
  std::atomic<bool> has_inline_peers_ = false;
  std::map<Gid, ServiceEnd*> ends_by_writer_;
  std::map<Gid, ServiceEnd*> clients_by_reader_;
  RecentMap<Gid, Requests> requests_{max_clients};  // by the client's writer
  std::size_t arrivals_ = 0;                       // in requests_
  std::map<std::array<std::uint8_t, 8>, Gid> inline_clients_;         // by the key in our headers
  RecentMap<Gid, std::array<std::uint8_t, 8>> keys_{max_clients};  // the reverse
  RecentMap<Gid, Beginning> beginnings_{max_clients};
  ContentFilters content_filters_;
  std::uint64_t next_key_;
};

}  // namespace tfloom::rtps

// All participants and endpoints discovered on a domain, including those of this process.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/ready_queue.hpp"
#include "core/sink.hpp"
#include "dds/endpoint.hpp"
#include "dds/feeder.hpp"
#include "dds/qos.hpp"

namespace tfloom::dds {

struct EndpointInfo {
  Gid gid{};
  Gid participant{};
  bool is_writer = false;
  std::string topic_name;  // as received, like the next two: untrusted bytes
  std::string type_name;
  std::string user_data;
  Qos qos;
};

struct ParticipantInfo {
  std::string user_data;
  std::vector<std::byte> node_list;  // its latest sample of ros_discovery_info, not decoded; empty: none received
};

class Graph {
 public:
  struct Snapshot {
    std::vector<std::pair<Gid, ParticipantInfo>> participants;
    std::vector<EndpointInfo> endpoints;
  };

  // Start to listen. `node_lists` names the topic in which participants list their nodes.
  Graph(Participant& participant, const TopicName& node_lists, const Qos& qos, const std::string& user_data);
  ~Graph();
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  [[nodiscard]] Snapshot snapshot();

  // Return a number that grows with each change of the snapshot.
  [[nodiscard]] std::uint64_t changes();

  // Post `token` whenever the graph has changed; nullptr ends this.
  void notify(ReadyQueue::Shared queue, ReadyQueue::Token token);

  void close();

 private:
  static void on_data_available(Entity, void* self);
  OwnedEntity create_reader(Entity topic, const Qos_* qos) const;
  void listen();
  bool drain();
  void update();  // requires mutex_ to be held, like the next six
  void update_participants();
  void update_endpoints(Entity reader, bool is_writer);
  void prompt_heartbeats();
  void prompt_heartbeat(const TopicName& topic) const;
  void update_node_lists();
  void put_node_list(std::span<const std::byte> data);

  Participant& participant_;
  const Library& library_;
  std::mutex mutex_;  // held during calls of the library; the listener does not acquire it
  std::map<Gid, ParticipantInfo> participants_;             // guarded by mutex_, like the next seven
  std::map<Gid, std::vector<std::byte>> early_node_lists_;  // of participants that are not discovered yet
  std::map<Gid, EndpointInfo> endpoints_;
  std::vector<TopicName> new_writers_;  // topics of reliable writers of Fast DDS that were just discovered
  std::uint64_t changes_ = 0;
  ReadyQueue::Shared queue_;
  ReadyQueue::Token token_ = 0;
  bool closed_ = false;
  Feeder::Task drain_task_;
  OwnedEntity node_list_topic_;  // constant after construction, like the next four
  OwnedEntity participant_reader_;
  OwnedEntity writer_reader_;
  OwnedEntity reader_reader_;
  OwnedEntity node_list_reader_;
};

}  // namespace tfloom::dds

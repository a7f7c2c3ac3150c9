// omniEvents, CORBA's event service by omniORB: every event that is published is a call of the channel, answered when
// the channel has it; the channel calls its consumers, on threads of omniORB's.

#include "tests/bench/blackboard/brokers.hpp"

#if PIZARRA_HAS_OMNIEVENTS
#include <condition_variable>
#include <deque>
#include <fmt/format.h>
#include <mutex>
#include <omniEvents/CosEventChannelAdmin.hh>
#include <omniEvents/CosLifeCycle.hh>
#include <stdexcept>
#endif

namespace pizarra::bench {

#if PIZARRA_HAS_OMNIEVENTS
namespace {

// One a process.
CORBA::ORB_ptr orb() {
  static int no_arguments = 0;
  static CORBA::ORB_var orb = CORBA::ORB_init(no_arguments, nullptr);
  return orb;
}

template <class Interface>
typename Interface::_ptr_type find(int port, std::string_view name) {
  CORBA::Object_var object = orb()->string_to_object(fmt::format("corbaloc::127.0.0.1:{}/{}", port, name).c_str());
  typename Interface::_ptr_type found = Interface::_narrow(object);
  if (CORBA::is_nil(found)) throw std::runtime_error(fmt::format("omniEvents has no {}", name));
  return found;
}

// The events that came, until they are taken.
class Inbox : public POA_CosEventComm::PushConsumer {
 public:
  void push(const CORBA::Any& event) override {
    const char* payload = nullptr;
    event >>= payload;
    {
      const std::scoped_lock lock(mutex_);
      events_.emplace_back(payload == nullptr ? "" : payload);
    }
    come_.notify_one();
  }
  void disconnect_push_consumer() override {}
  std::string next() {
    std::unique_lock lock(mutex_);
    come_.wait(lock, [this] { return !events_.empty(); });
    std::string event = std::move(events_.front());
    events_.pop_front();
    return event;
  }

 private:
  std::mutex mutex_;
  std::condition_variable come_;
  std::deque<std::string> events_;
};

class OmniEventsClient : public BrokerClient {
 public:
  explicit OmniEventsClient(int port) : channel_(find<CosEventChannelAdmin::EventChannel>(port, broker_topic)) {
    CosEventChannelAdmin::SupplierAdmin_var admin = channel_->for_suppliers();
    channel_end_ = admin->obtain_push_consumer();
    channel_end_->connect_push_supplier(CosEventComm::PushSupplier::_nil());
  }
  void publish_acknowledged(std::string_view payload) override {
    CORBA::Any event;
    event <<= std::string(payload).c_str();
    channel_end_->push(event);
  }
  // There is no other way than a call.
  void publish(std::string_view payload) override { publish_acknowledged(payload); }
  void flush() override {}
  void watch() override {
    CORBA::Object_var root = orb()->resolve_initial_references("RootPOA");
    PortableServer::POA_var adapter = PortableServer::POA::_narrow(root);
    PortableServer::POAManager_var manager = adapter->the_POAManager();
    manager->activate();
    PortableServer::ObjectId_var id = adapter->activate_object(&inbox_);
    CosEventComm::PushConsumer_var self = inbox_._this();
    CosEventChannelAdmin::ConsumerAdmin_var admin = channel_->for_consumers();
    CosEventChannelAdmin::ProxyPushSupplier_var supplier = admin->obtain_push_supplier();
    supplier->connect_push_consumer(self);
  }
  std::string message() override { return inbox_.next(); }

 private:
  CosEventChannelAdmin::EventChannel_var channel_;
  CosEventChannelAdmin::ProxyPushConsumer_var channel_end_;
  Inbox inbox_;
};

std::vector<std::string> command_line(const std::string& program, int port, const std::string& folder) {
  return {program, "-p", std::to_string(port), "-l", folder, "-f", "-t", folder + "/trace"};
}

// By default a channel gathers events for a tenth of a second.
void make_channel(int port) {
  CosLifeCycle::GenericFactory_var factory = find<CosLifeCycle::GenericFactory>(port, "omniEvents");
  CosLifeCycle::Key key;
  key.length(1);
  key[0].id = CORBA::string_dup("EventChannel");
  key[0].kind = CORBA::string_dup("object interface");
  CosLifeCycle::Criteria criteria;
  criteria.length(2);
  criteria[0].name = CORBA::string_dup("InsName");
  criteria[0].value <<= broker_topic.data();
  criteria[1].name = CORBA::string_dup("CyclePeriod_ns");
  criteria[1].value <<= CORBA::ULong{1000};
  CORBA::Object_var channel = factory->create_object(key, criteria);
}

// In a process of its own: the bench forks as long as it has no threads, and omniORB starts some.
void prepare(int port) {
  Child maker = Child::running([&](Pipe& parent) {
    make_channel(port);
    parent.say(0);
  });
  maker.pipe().hear();
}

std::unique_ptr<BrokerClient> connect(int port, bool) { return std::make_unique<OmniEventsClient>(port); }

}  // namespace

BrokerKind omni_events() { return {"omniEvents", "omniEvents", command_line, prepare, connect}; }
#else
BrokerKind omni_events() { return {"omniEvents", "omniEvents", {}, {}, {}}; }
#endif

}  // namespace pizarra::bench

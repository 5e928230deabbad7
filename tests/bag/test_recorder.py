"""Recorders on the wire inside the process, and what they choose."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, cast

import pytest
from tests.bag.written_bags import raising
from tests.conftest import wait_until

from tfloom.bag import open_bag
from tfloom.bag.errors import BagError
from tfloom.bag.qos_profiles import adapted, parse_profiles, profiles_text, read_overrides, warnings_of
from tfloom.bag.recording import recorded_topics, run
from tfloom.bag.recording import recorder as recorder_module
from tfloom.bag.recording.recorded_topics import RecordOptions
from tfloom.bag.recording.recorder import Recorder
from tfloom.bag.topic_choice import TopicChoice
from tfloom.bag.values import Definition
from tfloom.bag.writing.bag_writer import WriterSettings
from tfloom.interfaces.rosbag2_interfaces.msg import WriteSplitEvent
from tfloom.interfaces.rosbag2_interfaces.srv import (
    IsDiscoveryRunning,
    IsPaused,
    Pause,
    Record,
    Resume,
    Snapshot,
    SplitBagfile,
    StartDiscovery,
    Stop,
    StopDiscovery,
)
from tfloom.interfaces.rosgraph_msgs.msg import Clock
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node import client_library
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.node.values.time import Time
from tfloom.rmw.base import NodeName, Topic
from tfloom.rmw.errors import ClosedError
from tfloom.rmw.events import Count, Event
from tfloom.rmw.local import wire as local
from tfloom.rmw.qos import PROFILES, HistoryPolicy, QoS, ReliabilityPolicy
from tfloom.rmw.qos import DurabilityPolicy as Durability


@pytest.fixture
def node(local_context: Context) -> Node:
    return Node("talker", context=local_context)


@pytest.fixture
def record(local_context: Context, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Any]:
    monkeypatch.setattr(recorder_module, "FLUSH_NS", 10_000_000)

    @contextmanager
    def start(
        choice: TopicChoice, settings: WriterSettings | None = None, **options: Any
    ) -> Iterator[Recorder]:
        asked = RecordOptions(choice, polling_interval_s=0.01, has_keyboard=False, **options)
        recorder = Recorder(tmp_path / "bag", settings or WriterSettings(), asked, context=local_context)
        recorder.start()
        try:
            yield recorder
        finally:
            recorder.stop()
            recorder.destroy_node()

    return start


def texts(folder: Path, topic: str = "/chatter") -> list[str]:
    with open_bag(folder) as bag:
        return [message.data for _, message in bag.read(topic)]


def test_topics_that_exist_and_that_appear_are_recorded(node: Node, record: Any, tmp_path: Path) -> None:
    early = node.create_publisher(String, "chatter", 10)
    with record(TopicChoice(["/chatter", "/late"])) as recorder:
        early.publish(String(data="a"))
        late = node.create_publisher(
            String, "late", QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        )
        late.publish(String(data="b"))
        wait_until(lambda: recorder.writer.queue.message_count == 2)
    assert texts(tmp_path / "bag") == ["a"]
    assert texts(tmp_path / "bag", "/late") == ["b"]
    with open_bag(tmp_path / "bag") as bag:
        (offered,) = parse_profiles(bag.topics["/late"].offered_qos)
        assert (offered.depth, offered.durability) == (3, Durability.TRANSIENT_LOCAL)
        (message,) = bag.messages("/chatter")
        assert 0 <= message.log_time_ns - message.publish_time_ns < 10**10


def test_messages_are_discarded_while_paused(node: Node, record: Any, tmp_path: Path) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    with record(TopicChoice(["/chatter"]), is_start_paused=True) as recorder:
        assert recorder.is_paused
        publisher.publish(String(data="a"))
        recorder.toggle_paused()
        publisher.publish(String(data="b"))
        recorder.toggle_paused()
        publisher.publish(String(data="c"))
    assert texts(tmp_path / "bag") == ["b"]


@pytest.fixture
def call(node: Node, local_context: Context) -> Iterator[Callable[..., Any]]:
    """Call a service of a recorder whose node is in the same context."""
    with SingleThreadedExecutor(context=local_context) as executor:
        executor.add_node(node)

        def call(recorder: Recorder, kind: Any, name: str, **fields: Any) -> Any:
            executor.add_node(recorder)
            client = node.create_client(kind, f"/rosbag2_recorder/{name}")
            assert client.wait_for_service(5.0)
            future = client.call_async(kind.Request(**fields))
            executor.spin_until_future_complete(future, 5.0)
            return future.result()

        yield call


def test_services_pause_split_and_resume(
    node: Node, record: Any, call: Callable[..., Any], tmp_path: Path
) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    events: list[WriteSplitEvent] = []
    node.create_subscription(WriteSplitEvent, "events/write_split", events.append, 1)
    with record(TopicChoice(["/chatter"])) as recorder:
        publisher.publish(String(data="a"))
        call(recorder, SplitBagfile, "split_bagfile")
        publisher.publish(String(data="b"))
        call(recorder, Pause, "pause")
        assert call(recorder, IsPaused, "is_paused").paused
        publisher.publish(String(data="lost"))
        call(recorder, Resume, "resume")
        assert not call(recorder, IsPaused, "is_paused").paused
        publisher.publish(String(data="c"))
        assert not call(recorder, Snapshot, "snapshot").success
    assert sorted(path.name for path in (tmp_path / "bag").glob("*.mcap")) == ["bag_0.mcap", "bag_1.mcap"]
    with open_bag(tmp_path / "bag") as bag:
        assert [file.message_count for file in bag.files] == [1, 2]
    assert texts(tmp_path / "bag") == ["a", "b", "c"]
    paths = [str(tmp_path / "bag" / f"bag_{number}.mcap") for number in range(2)]
    (event,) = events
    assert event == WriteSplitEvent(closed_file=paths[0], opened_file=paths[1], node_name="/rosbag2_recorder")


def test_services_stop_and_record_again(
    node: Node, record: Any, call: Callable[..., Any], tmp_path: Path, capfd: Any
) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    again = str(tmp_path / "again")
    with record(TopicChoice(["/chatter"])) as recorder:
        publisher.publish(String(data="a"))
        refused = call(recorder, Record, "record", uri=again)
        assert (refused.return_code, refused.error_string) == (1, "Recorder is already recording.")
        call(recorder, Stop, "stop")
        assert not recorder.is_recording
        assert texts(tmp_path / "bag") == ["a"]
        # None of these ends the program, although there is no file to write into.
        call(recorder, Stop, "stop")
        call(recorder, SplitBagfile, "split_bagfile")
        recorder.toggle_paused()
        recorder.toggle_paused()
        failed = call(recorder, Record, "record")
        assert failed.return_code == 1
        assert failed.error_string == f"{tmp_path / 'bag'}: it exists already; choose another folder"
        begun = call(recorder, Record, "record", uri=again)
        assert (begun.return_code, begun.error_string) == (0, "")
        assert call(recorder, IsPaused, "is_paused").paused
        publisher.publish(String(data="lost"))
        call(recorder, Resume, "resume")
        publisher.publish(String(data="b"))
        call(recorder, Stop, "stop")
        assert recorder.failure is None
    assert texts(tmp_path / "again") == ["b"]
    said = capfd.readouterr().err
    for refusal in (
        "Record request while already recording",
        "Stop request while not in recording",
        "SplitBagfile request while not in recording",
    ):
        assert said.count(f"Received {refusal}. Ignoring request.") == 1
    assert f"Error during Record request: {tmp_path / 'bag'}: it exists already" in said


def test_services_start_and_stop_discovery(node: Node, record: Any, call: Callable[..., Any]) -> None:
    def ask(kind: Any, name: str) -> tuple[int, str]:
        response = call(recorder, kind, name)
        return response.return_code, response.error_string

    with record(TopicChoice(["/early", "/late"]), is_discovery_disabled=True) as recorder:
        assert not call(recorder, IsDiscoveryRunning, "is_discovery_running").running
        assert ask(StopDiscovery, "stop_discovery") == (1, "Discovery is not running.")
        assert ask(StartDiscovery, "start_discovery") == (0, "")
        assert call(recorder, IsDiscoveryRunning, "is_discovery_running").running
        assert ask(StartDiscovery, "start_discovery") == (1, "Discovery is already running.")
        node.create_publisher(String, "early", 10)
        wait_until(lambda: recorder._topics._recorded.keys() == {"/early"})
        assert ask(StopDiscovery, "stop_discovery") == (0, "")
        assert not call(recorder, IsDiscoveryRunning, "is_discovery_running").running
        node.create_publisher(String, "late", 10)
        assert ask(StartDiscovery, "start_discovery") == (0, "")
        wait_until(lambda: not recorder.is_discovery_running)  # because all topics are found
        assert recorder._topics._recorded.keys() == {"/early", "/late"}
        call(recorder, Stop, "stop")
        assert ask(StartDiscovery, "start_discovery") == (1, "Recorder is not currently recording.")


def test_snapshot_is_refused_when_the_recording_has_stopped(record: Any, call: Callable[..., Any]) -> None:
    with record(TopicChoice(["/chatter"]), WriterSettings(is_snapshot=True)) as recorder:
        recorder.stop()
        assert not call(recorder, Snapshot, "snapshot").success
        assert recorder.failure is None


def test_snapshot_has_the_newest_messages(node: Node, record: Any, tmp_path: Path) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    with record(TopicChoice(["/chatter"]), WriterSettings(cache_size=4000, is_snapshot=True)) as recorder:
        for number in range(500):
            publisher.publish(String(data=f"{number}"))
        assert recorder.take_snapshot()
        publisher.publish(String(data="never written"))
    found = texts(tmp_path / "bag")
    assert 30 < len(found) < 100
    assert found == [str(number) for number in range(500 - len(found), 500)]


def test_split_of_a_snapshot_writes_no_message(node: Node, record: Any, tmp_path: Path) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    with record(TopicChoice(["/chatter"]), WriterSettings(is_snapshot=True)) as recorder:
        publisher.publish(String(data="a"))
        recorder.split_bagfile()
        assert recorder.writer.message_count == 0
        assert recorder.take_snapshot()
    with open_bag(tmp_path / "bag") as bag:
        assert [file.message_count for file in bag.files] == [0, 1]


def test_one_thread_at_a_time_writes(record: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    held: list[bool] = []
    with record(TopicChoice(["/chatter"]), WriterSettings(is_snapshot=True)) as recorder:
        with monkeypatch.context() as patched:
            for name in ("write_present", "split"):
                patched.setattr(recorder.writer, name, lambda: held.append(recorder._lock.locked()))
            recorder.take_snapshot()
            recorder.split_bagfile()
        assert held == [True, True]


def test_topics_are_left_when_the_recording_stops(node: Node, record: Any) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    with record(TopicChoice(["/chatter"])) as recorder:
        assert publisher.get_subscription_count() == 1
        recorder.stop()
        assert publisher.get_subscription_count() == 0


def test_losses_are_counted_until_the_topic_is_left() -> None:
    class Reader:
        def take_event(self, _: Event) -> Count:
            return Count(3, 3)

        def close(self) -> None:
            pass

    recorded = recorded_topics._Recorded(QoS(), 1)
    assert recorded.count_lost() == 0
    recorded.reader = cast("Any", Reader())
    assert recorded.count_lost() == 3
    recorded.destroy()
    assert (recorded.reader, recorded.count_lost()) == (None, 3)


def test_topic_that_appears_while_others_are_listed_is_recorded(
    node: Node, record: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    with record(TopicChoice(["/chatter", "/late"]), is_discovery_disabled=True) as recorder:
        topics = recorder._topics
        listed = topics._topics
        publishers: list[object] = []

        def list_topics(graph: Any) -> Any:
            found = listed(graph)
            if not publishers:
                publishers.append(node.create_publisher(String, "late", 10))
            return found

        monkeypatch.setattr(topics, "_topics", list_topics)
        topics.subscribe_all()
        assert topics._recorded == {}
        topics.subscribe_changed()
        assert topics._recorded.keys() == {"/late"}


@pytest.fixture
def record_odd(local_context: Context, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Any]:
    """Record a topic whose type gets a definition after some searches; return the recorder and its searches."""
    wire = local.open_participant(local_context.get_domain_id())
    wire.create_writer(NodeName("/", "odd"), Topic("/odd", "odd_msgs/msg/Odd", ""), QoS())
    asked: list[str] = []

    def start(found_at: int) -> tuple[Recorder, list[str]]:
        def find(_: str, __: str = "") -> Definition | None:
            return Definition("ros2msg", "int32 x") if len(asked) >= found_at else None

        monkeypatch.setattr(recorded_topics, "find_definition", find)
        options = RecordOptions(TopicChoice(["/odd"]), has_keyboard=False)
        learn = lambda _, type_name: asked.append(type_name)  # noqa: E731
        recorder = Recorder(tmp_path / "bag", WriterSettings(), options, learn=learn, context=local_context)
        recorder.start()
        return recorder, asked

    return start


def definition_of_odd(recorder: Recorder) -> Any:
    recorder.stop()
    recorder.destroy_node()
    with open_bag(recorder.writer.folder) as bag:
        return bag.topics["/odd"].definition


@pytest.mark.parametrize("found_at", [2, 9])
def test_type_that_is_unknown_is_asked_for_again_at_the_end(
    record_odd: Callable[..., Any], monkeypatch: pytest.MonkeyPatch, capfd: Any, found_at: int
) -> None:
    monkeypatch.setattr(recorded_topics, "SEARCH_S", 1e6)
    recorder, asked = record_odd(found_at)
    assert len(asked) == 1
    definition = definition_of_odd(recorder)
    assert asked == 2 * ["odd_msgs/msg/Odd"]
    is_found = found_at == 2
    assert (definition is not None) == is_found
    assert ("There is no definition of 'odd_msgs/msg/Odd' here" in capfd.readouterr().err) != is_found


def test_bag_is_completed_though_its_last_search_fails(
    record_odd: Callable[..., Any], monkeypatch: pytest.MonkeyPatch, capfd: Any
) -> None:
    monkeypatch.setattr(recorded_topics, "SEARCH_S", 1e6)
    recorder, _ = record_odd(9)
    monkeypatch.setattr(recorder._topics, "_learn", raising(ClosedError("the participant was closed")))
    assert definition_of_odd(recorder) is None
    assert "There is no definition of 'odd_msgs/msg/Odd' here" in capfd.readouterr().err


@pytest.mark.parametrize("found_at", [3, 99])
def test_type_that_is_unknown_is_asked_for_again_some_times(
    record_odd: Callable[..., Any], monkeypatch: pytest.MonkeyPatch, capfd: Any, found_at: int
) -> None:
    monkeypatch.setattr(recorded_topics, "SEARCH_S", 0.0)
    recorder, asked = record_odd(found_at)
    wait_until(lambda: not recorder.is_discovery_running, what="the end of all searches")
    is_found = found_at == 3
    assert len(asked) == (3 if is_found else 1 + recorded_topics.MAX_SEARCHES)
    definition = definition_of_odd(recorder)
    assert len(asked) == (3 if is_found else 1 + recorded_topics.MAX_SEARCHES)
    assert (definition and definition.text) == ("int32 x" if is_found else None)
    assert ("There is no definition of" in capfd.readouterr().err) != is_found


def test_overridden_profile_keeps_all_and_what_it_refuses_is_told_once(
    node: Node, record: Any, capfd: Any
) -> None:
    reliable = QoS(ReliabilityPolicy.RELIABLE, depth=1)
    node.create_publisher(String, "chatter", 10)
    with record(TopicChoice(["/chatter"]), qos_overrides={"/chatter": reliable}) as recorder:
        (end,) = node.get_subscriptions_info_by_topic("/chatter")
        assert end.qos_profile.history == HistoryPolicy.KEEP_ALL
        node.create_publisher(String, "chatter", PROFILES["sensor_data"].depth)  # one more that is reliable
        best_effort = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
        node.create_publisher(String, "chatter", best_effort)
        with recorder._lock:
            recorder._topics.subscribe_all()
            recorder._topics.subscribe_all()
    said = capfd.readouterr().err
    assert said.count("A new publisher of '/chatter' offers a lower quality") == 1


def test_profile_receives_from_all_publishers() -> None:
    strong = QoS(ReliabilityPolicy.RELIABLE, DurabilityPolicy.TRANSIENT_LOCAL)
    weak = QoS(ReliabilityPolicy.BEST_EFFORT, DurabilityPolicy.VOLATILE)
    for offers, reliability, durability, count in (
        ([], ReliabilityPolicy.RELIABLE, DurabilityPolicy.VOLATILE, 0),
        ([strong, strong], ReliabilityPolicy.RELIABLE, DurabilityPolicy.TRANSIENT_LOCAL, 0),
        ([strong, weak], ReliabilityPolicy.BEST_EFFORT, DurabilityPolicy.VOLATILE, 2),
        ([weak, weak], ReliabilityPolicy.BEST_EFFORT, DurabilityPolicy.VOLATILE, 0),
    ):
        qos = adapted(offers)
        assert (qos.reliability, qos.durability) == (reliability, durability)
        assert len(warnings_of("/chatter", offers)) == count


@pytest.fixture
def ask(ros_domain: int, tmp_path: Path) -> Iterator[Callable[..., None]]:
    """Record with a function of the default context, on this thread, as a command does."""
    client_library.init(args=[], domain_id=ros_domain)

    def ask(**arguments: Any) -> None:
        options = RecordOptions(TopicChoice(["/late"]), polling_interval_s=0.01, has_keyboard=False)
        run.record(tmp_path / "bag", WriterSettings(), options, **arguments)

    yield ask
    client_library.try_shutdown()


def test_failure_ends_the_recording_of_a_command(
    ask: Callable[..., None], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    fail = raising(ValueError("odd"))
    monkeypatch.setattr(recorded_topics.RecordedTopics, "subscribe_changed", fail)
    stop = threading.Event()
    overdue = threading.Timer(20, stop.set)
    overdue.start()
    with pytest.raises(BagError, match="no more topics can be subscribed to: ValueError: odd"):
        ask(stop=stop)
    assert not stop.is_set()
    overdue.cancel()
    assert (tmp_path / "bag" / "metadata.yaml").exists()


def test_ctrl_c_does_not_interrupt_the_completion_of_a_bag(
    ask: Callable[..., None], monkeypatch: pytest.MonkeyPatch
) -> None:
    stop, handlers = threading.Event(), []
    complete = Recorder.stop

    def stop_recording(recorder: Recorder) -> None:
        handlers.append(signal.getsignal(signal.SIGINT))
        complete(recorder)

    monkeypatch.setattr(Recorder, "stop", stop_recording)
    stop.set()
    before = signal.getsignal(signal.SIGINT)
    ask(stop=stop)
    assert handlers == [signal.SIG_IGN]
    assert signal.getsignal(signal.SIGINT) is before


def test_ctrl_c_while_a_bag_is_completed_comes_when_it_is(
    node: Node, record: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    with record(TopicChoice(["/chatter"])) as recorder:
        publisher.publish(String(data="first"))
        wait_until(lambda: recorder.writer.queue.message_count + recorder.writer.message_count > 0)
        close = recorder.writer.close

        def interrupted_close() -> None:
            signal.raise_signal(signal.SIGINT)
            close()

        monkeypatch.setattr(recorder.writer, "close", interrupted_close)
        with pytest.raises(KeyboardInterrupt):
            recorder.stop()
        assert not recorder.is_recording
        assert texts(tmp_path / "bag") == ["first"]


def test_full_cache_drops_and_counts(node: Node, record: Any, tmp_path: Path, capfd: Any) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    settings = WriterSettings(cache_size=500)
    with (
        record(TopicChoice(["/chatter"]), settings) as recorder,
        recorder._lock,
    ):  # nothing is written meanwhile
        for number in range(100):
            publisher.publish(String(data=f"{number}"))
        queue = recorder.writer.queue
        assert queue.message_count + queue.dropped_count == 100
        assert queue.size <= 1000
    assert "Cache buffers lost messages: " in capfd.readouterr().err
    assert len(texts(tmp_path / "bag")) == recorder.writer.queue.message_count < 100


def test_simulated_time_stamps_messages(
    node: Node, record: Any, local_context: Context, tmp_path: Path
) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    clock = node.create_publisher(Clock, "/clock", 10)
    with record(TopicChoice(["/chatter"]), use_sim_time=True) as recorder:
        publisher.publish(String(data="before the first /clock"))
        with SingleThreadedExecutor(context=local_context) as executor:
            executor.add_node(recorder)
            clock.publish(Clock(clock=Time(seconds=5).to_msg()))
            while recorder.get_clock().now().nanoseconds == 0:
                executor.spin_once(1.0)
        publisher.publish(String(data="a"))
        recorder.stop()
        recorder.record(str(tmp_path / "again"))
        recorder.resume()
        publisher.publish(String(data="b"))
    for folder in ("bag", "again"):
        with open_bag(tmp_path / folder) as bag:
            assert [message.log_time_ns for message in bag.messages()] == [5 * 10**9]


def test_node_without_a_bag_leaves(node: Node, local_context: Context, tmp_path: Path) -> None:
    with pytest.raises(BagError, match="it exists already"):
        Recorder(tmp_path, WriterSettings(), RecordOptions(has_keyboard=False), context=local_context)
    assert "rosbag2_recorder" not in node.get_node_names()


def test_hidden_topics_and_those_of_two_types_are_left_out(node: Node, record: Any, capfd: Any) -> None:
    node.create_publisher(String, "_hidden", 1)
    node.create_publisher(String, "two", 1)
    node.create_publisher(Clock, "two", 1)
    node.create_subscription(String, "unpublished", print, 1)
    with record(TopicChoice(all_topics=True)) as recorder:
        assert recorder._topics._recorded.keys() == {"/events/write_split", "/parameter_events", "/rosout"}
    said = capfd.readouterr().err
    assert "Hidden topics are not recorded. Enable them with --include-hidden-topics" in said
    assert "Topic '/two' has more than one type, and can't be recorded: rosgraph_msgs" in said


def test_choices() -> None:
    types = {"/scan": "sensor_msgs/msg/LaserScan", "/tf": "tf2_msgs/msg/TFMessage"}
    add = "/add/_service_event"
    topics = {**types, "/front/scan": types["/scan"], add: "example_interfaces/srv/AddTwoInts_Event"}
    for choice, expected in (
        (TopicChoice(), set[str]()),
        (TopicChoice(all_topics=True), {"/scan", "/tf", "/front/scan"}),
        (TopicChoice(all_services=True), {add}),
        (TopicChoice(services=["/add"]), {add}),
        (TopicChoice(["/tf"]), {"/tf"}),
        (TopicChoice(topic_types=[types["/scan"]]), {"/scan", "/front/scan"}),
        (TopicChoice(regex="scan|add"), {"/scan", "/front/scan", add}),
        (TopicChoice(all_topics=True, exclude_regex="^/front"), {"/scan", "/tf"}),
        (TopicChoice(all_topics=True, exclude_topics=["/tf"]), {"/scan", "/front/scan"}),
        (TopicChoice(all_topics=True, exclude_topic_types=[types["/scan"]]), {"/tf"}),
        (TopicChoice(all_topics=True, all_services=True, exclude_services=["/add"]), {*types, "/front/scan"}),
    ):
        assert {name for name, kind in topics.items() if choice.wants(name, kind)} == expected, choice


def test_profiles_in_yaml(tmp_path: Path) -> None:
    profiles = [
        QoS(),
        QoS(ReliabilityPolicy.BEST_EFFORT, depth=3, deadline_ns=1_500_000_000),
        PROFILES["sensor_data"],
    ]
    assert [profile.resolved() for profile in parse_profiles(profiles_text(profiles))] == [
        profile.resolved() for profile in profiles
    ]
    old = "- history: 3\n  depth: 0\n  reliability: 1\n  durability: 2\n  liveliness: 1\n"
    old += "  deadline:\n    sec: 2147483647\n    nsec: 4294967295"
    (humble,) = parse_profiles(old)
    assert (humble.history, humble.reliability) == (HistoryPolicy.UNKNOWN, ReliabilityPolicy.RELIABLE)
    assert parse_profiles("- {reliability: odd}") == parse_profiles("[") == parse_profiles("") == []
    path = tmp_path / "qos.yaml"
    path.write_text("/scan: {reliability: best_effort, depth: 2}")
    assert read_overrides(path) == {"/scan": QoS(ReliabilityPolicy.BEST_EFFORT, depth=2)}
    for text, reason in (
        ("/scan: {relibility: 1}", "relibility"),
        ("3", "must be a map"),
        ("a: [", "isn't YAML"),
    ):
        path.write_text(text)
        with pytest.raises(BagError, match=reason):
            read_overrides(path)


def test_no_message_is_lost_from_many_threads(node: Node, record: Any, tmp_path: Path) -> None:
    publishers = [node.create_publisher(String, f"t{number}", 10) for number in range(4)]
    with record(TopicChoice(regex="^/t[0-9]$")) as recorder:

        def publish(publisher: Any) -> None:
            for number in range(500):
                publisher.publish(String(data=f"{number}"))

        wait_until(lambda: len(recorder._topics._recorded) == 4)
        threads = [threading.Thread(target=publish, args=(publisher,)) for publisher in publishers]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    for number in range(4):
        assert texts(tmp_path / "bag", f"/t{number}") == [str(count) for count in range(500)]

"""For each callback of the public API, the test row that makes it raise; see `public_callables`."""

from __future__ import annotations

OWN = "- of the library itself: it is given a function of ours"
OF_A_TEST = "- of a test: its exception fails that test"
OF_THE_CALLER = "- called at once, for the caller, who gets the exception"
NOT_CALLED = "- removed, or refused: it is not called"
OF_A_GROUP = "- no executor calls it: its exception ends the node, see tests/node/test_async_node.py"
OF_A_THREAD = (
    "- a thread of its endpoint calls it, and reports its exception: tests/node/test_later_releases.py"
)
RARE = "- an event handler as the others: the wires lose no message that a test could provoke"

_BY_FILE: dict[str, dict[str, str]] = {
    "launch.actions.for_loop": {
        "ForEach.__init__(function)": "for each",
        "ForLoop.__init__(function)": "for loop",
    },
    "launch.actions.opaque": {
        "OpaqueCoroutine.__init__(coroutine)": "opaque coroutine",
        "OpaqueFunction.__init__(function)": "opaque function",
    },
    "launch.core.base_classes": {
        "Condition.__init__(predicate)": "condition",
    },
    "launch.entities.event_handler": {
        "BaseEventHandler.__init__(matcher)": "matcher",
        "EventHandler.__init__(matcher)": "matcher",
    },
    "launch.events.event_handlers": {
        "OnActionEventBase.__init__(action_matcher)": "matcher of actions",
        "OnActionEventBase.__init__(on_event)": "event of actions",
        "OnExecutionComplete.__init__(on_completion)": "completion",
        "OnExecutionComplete.__init__(target_action)": "target of completion",
        "OnProcessExit.__init__(on_exit)": "exit",
        "OnProcessExit.__init__(target_action)": "target of exit",
        "OnProcessIO.__init__(target_action)": "target of output",
        "OnProcessStart.__init__(on_start)": "start",
        "OnProcessStart.__init__(target_action)": "target of start",
        "OnShutdown.__init__(on_shutdown)": "shutdown",
    },
    "launch.events.process": {
        "ProcessTargetedEvent.__init__(process_matcher)": "signal",
        "SignalProcess.__init__(process_matcher)": "signal",
    },
    "launch.ros.actions.lifecycle_transition": {
        "OnStateTransition.__init__(matcher)": "state transition",
    },
    "launch.ros.lifecycle_events": {
        "ChangeState.__init__(lifecycle_node_matcher)": "matcher",
    },
    "launch.testing.assert_output": {
        "assertInStderr(output_filter)": OF_A_TEST,
        "assertInStdout(output_filter)": OF_A_TEST,
        "assertInStream(output_filter)": OF_A_TEST,
    },
    "launch.testing.fixtures.fixture": {
        "fixture(decorated)": OF_A_TEST,
    },
    "launch.testing.io_handler": {
        "ActiveIoHandler.waitFor(output_filter)": OF_A_TEST,
    },
    "launch.testing.legacy": {
        "LaunchTestService.add_output_test(output_filter)": OF_A_TEST,
        "LaunchTestService.add_output_test(output_test)": OF_A_TEST,
    },
    "launch.testing.loader": {
        "TestRun.__init__(test_description_function)": OF_A_TEST,
        "TestRun.normalized_test_description(ready_fn)": OF_A_TEST,
    },
    "launch.testing.process": {
        "ProcessProxy.__init__(output_filter)": OF_A_TEST,
        "ProcessProxy.wait_for_output(condition)": OF_A_TEST,
    },
    "launch.testing.readiness": {
        "ReadyAggregator.__init__(callback)": OF_A_TEST,
    },
    "launch.testing.ros.topics": {
        "DataRepublisher.__init__(transform_fn)": "subscription",
        "WaitForTopics.__init__(trigger)": OF_A_TEST,
    },
    "node.action.client": {
        "ActionClient.send_goal_async(feedback_callback)": "action_feedback",
    },
    "node.action.server": {
        "ActionServer.__init__(cancel_callback)": "action_cancel",
        "ActionServer.__init__(execute_callback)": "action_execute",
        "ActionServer.__init__(goal_callback)": "action_goal",
        "ActionServer.__init__(handle_accepted_callback)": "action_handle_accepted",
        "ActionServer.notify_execute(execute_callback)": "action_execute",
        "ActionServer.register_cancel_callback(cancel_callback)": "action_cancel",
        "ActionServer.register_execute_callback(execute_callback)": "action_execute",
        "ActionServer.register_goal_callback(goal_callback)": "action_goal",
        "ActionServer.register_handle_accepted_callback(handle_accepted_callback)": "action_handle_accepted",
    },
    "node.action.server_goal_handle": {
        "ServerGoalHandle.execute(execute_callback)": "action_execute",
    },
    "node.base.node_base": {
        "Node.add_on_set_parameters_callback(callback)": "on_set_parameters",
        "Node.add_post_set_parameters_callback(callback)": "post_set_parameters",
        "Node.add_pre_set_parameters_callback(callback)": "pre_set_parameters",
        "Node.create_guard_condition(callback)": "guard_condition",
        "Node.create_publisher(event_callbacks)": "matched_of_publisher",
        "Node.create_service(callback)": "service",
        "Node.create_subscription(callback)": "subscription",
        "Node.create_subscription(event_callbacks)": "matched_of_subscription",
        "Node.create_timer(callback)": "timer",
        "Node.remove_on_set_parameters_callback(callback)": NOT_CALLED,
        "Node.remove_post_set_parameters_callback(callback)": NOT_CALLED,
        "Node.remove_pre_set_parameters_callback(callback)": NOT_CALLED,
    },
    "node.builtin.parameter_client": {
        "AsyncParameterClient.delete_parameters(callback)": "parameter_client",
        "AsyncParameterClient.describe_parameters(callback)": "parameter_client",
        "AsyncParameterClient.get_parameter_types(callback)": "parameter_client",
        "AsyncParameterClient.get_parameters(callback)": "parameter_client",
        "AsyncParameterClient.list_parameters(callback)": "parameter_client",
        "AsyncParameterClient.load_parameter_file(callback)": "parameter_client",
        "AsyncParameterClient.load_parameter_file_atomically(callback)": "parameter_client",
        "AsyncParameterClient.on_parameter_event(callback)": "subscription",
        "AsyncParameterClient.on_parameter_event(event_callbacks)": "matched_of_subscription",
        "AsyncParameterClient.set_parameters(callback)": "parameter_client",
        "AsyncParameterClient.set_parameters_atomically(callback)": "parameter_client",
    },
    "node.builtin.parameter_event_handler": {
        "ParameterCallbackHandle.__init__(callback)": "parameter_callback",
        "ParameterEventCallbackHandle.__init__(callback)": "parameter_event_callback",
        "ParameterEventHandler.__init__(event_callbacks)": "matched_of_subscription",
        "ParameterEventHandler.add_parameter_callback(callback)": "parameter_callback",
        "ParameterEventHandler.add_parameter_event_callback(callback)": "parameter_event_callback",
        "ParameterEventHandler.remove_parameter_callback(handle)": NOT_CALLED,
        "ParameterEventHandler.remove_parameter_event_callback(handle)": NOT_CALLED,
    },
    "node.clock.clock": {
        "Clock.create_jump_callback(post_callback)": "jump_post_callback",
        "Clock.create_jump_callback(pre_callback)": "jump_pre_callback",
        "JumpHandle.__init__(post_callback)": "jump_post_callback",
        "JumpHandle.__init__(pre_callback)": "jump_pre_callback",
    },
    "node.context.context": {
        "Context.add_shutdown_hook(hook)": "on_shutdown",
        "Context.on_shutdown(callback)": "on_shutdown",
        "Context.remove_shutdown_hook(hook)": NOT_CALLED,
    },
    "node.endpoints.client": {
        "Client.__init__(executor)": OWN,
        "Client.__init__(other_type)": OWN,
        "Client.__init__(start_timer)": OWN,
    },
    "node.endpoints.endpoint": {
        "Receiver.set_on_new_callback(callback)": OF_A_THREAD,
    },
    "node.endpoints.publisher": {
        "Publisher.__init__(event_callbacks)": "matched_of_publisher",
    },
    "node.endpoints.service": {
        "Service.__init__(callback)": "service",
    },
    "node.endpoints.subscription": {
        "Subscription.filter_samples(accepts)": OWN,
        "Subscription.__init__(callback)": "subscription",
        "Subscription.__init__(event_callbacks)": "matched_of_subscription",
    },
    "node.executing.callback_groups": {
        "CallbackGroup.park(post_again)": OWN,
    },
    "node.executing.event_handler": {
        "EventHandler.__init__(callback)": "matched_of_subscription",
        "SubscriptionEventCallbacks.__init__(deadline)": "deadline_of_subscription",
        "SubscriptionEventCallbacks.__init__(incompatible_qos)": "incompatible_qos_of_subscription",
        "SubscriptionEventCallbacks.__init__(incompatible_type)": "incompatible_type_of_subscription",
        "SubscriptionEventCallbacks.__init__(liveliness)": "liveliness_of_subscription",
        "SubscriptionEventCallbacks.__init__(matched)": "matched_of_subscription",
        "SubscriptionEventCallbacks.__init__(message_lost)": RARE,
        "_EventCallbacks.__init__(deadline)": "deadline_of_publisher",
        "_EventCallbacks.__init__(incompatible_qos)": "incompatible_qos_of_publisher",
        "_EventCallbacks.__init__(incompatible_type)": "incompatible_type_of_publisher",
        "_EventCallbacks.__init__(liveliness)": "liveliness_of_publisher",
        "_EventCallbacks.__init__(matched)": "matched_of_publisher",
    },
    "node.executing.executor": {
        "Executor.wait_for_ready_callbacks(condition)": OF_THE_CALLER,
        "Executor.run_waiting(then)": OWN,
    },
    "node.async_node": {
        "AsyncNode.create_service(callback)": OF_A_GROUP,
        "AsyncNode.create_subscription(callback)": OF_A_GROUP,
        "AsyncNode.create_timer(callback)": OF_A_GROUP,
    },
    "node.executing.executors": {
        "await_or_execute(callback)": "task_coroutine",
        "MultiThreadedExecutor.run_waiting(then)": OWN,
    },
    "node.executing.guard_condition": {
        "GuardCondition.__init__(callback)": "guard_condition",
    },
    "node.executing.task": {
        "Future.add_done_callback(callback)": "done_callback_of_a_future",
        "Future.remove_done_callback(callback)": NOT_CALLED,
        "Future.when_complete(resume)": "resumption_of_a_future",
        "Task.__init__(handler)": "task",
        "Task.on_resume(resume)": OWN,
        "TaskRunner.create_task(callback)": "task",
    },
    "node.executing.timer": {
        "Timer.set_on_reset_callback(callback)": OF_THE_CALLER,
        "Timer.__init__(callback)": "timer",
    },
    "node.executing.work_queue": {
        "WorkQueue.create_task(callback)": "task",
    },
    "node.lifecycle.managed_entity": {
        "SimpleManagedEntity.when_enabled(when_not_enabled)": OF_THE_CALLER,
        "SimpleManagedEntity.when_enabled(wrapped)": OF_THE_CALLER,
    },
    "node.qos.qos_overriding_options": {
        "QoSOverridingOptions.__init__(callback)": "qos_overriding",
        "QoSOverridingOptions.with_default_policies(callback)": "qos_overriding",
    },
    "tf2_ros.buffer_interface": {
        "ConvertRegistration.add_convert(callback)": "transform_registration",
        "ConvertRegistration.add_from_msg(callback)": "transform_registration",
        "ConvertRegistration.add_to_msg(callback)": "transform_registration",
        "TransformRegistration.add(callback)": "transform_registration",
    },
    "tf2_ros.input_aligner": {
        "InputAligner.registerCallback(callback)": "filter_aligner",
    },
    "tf2_ros.message_filter": {
        "MessageFilter.registerFailureCallback(callback)": "filter_failure",
    },
    "tf2_ros.message_filters": {
        "SimpleFilter.registerCallback(cb)": "filter_itself",
    },
    "tfloom_sensing.diagnostic_tasks": {
        "FunctionDiagnosticTask.__init__(fn)": "diagnostic_function_task",
    },
    "tfloom_sensing.interactive_marker_server": {
        "InteractiveMarkerServer.insert(feedback_callback)": "marker_feedback",
        "InteractiveMarkerServer.setCallback(feedback_callback)": "marker_feedback",
        "_Callbacks.set_callback(callback)": "marker_feedback",
    },
    "tfloom_sensing.menu_handler": {
        "MenuHandler.doInsert(feedback_cb)": "marker_menu",
        "MenuHandler.insert(callback)": "marker_menu",
    },
}
COVERED = {f"{file}.{function}": row for file, rows in _BY_FILE.items() for function, row in rows.items()}
"""By `module.function(parameter)`: the name of a row, or the reason why there is none."""

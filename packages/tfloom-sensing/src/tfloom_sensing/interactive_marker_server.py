"""Markers that users move in viewers: interactive_markers' InteractiveMarkerServer."""

from __future__ import annotations

import contextlib
import copy
from collections.abc import Callable
from threading import Lock
from typing import Any

from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.geometry_msgs.msg import Pose
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.visualization_msgs.msg import (
    InteractiveMarker,
    InteractiveMarkerFeedback,
    InteractiveMarkerPose,
    InteractiveMarkerUpdate,
)
from tfloom.interfaces.visualization_msgs.srv import GetInteractiveMarkers
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time

__all__ = ["InteractiveMarkerServer", "MarkerContext", "UpdateContext"]

Callback = Callable[[InteractiveMarkerFeedback], Any]

_OTHERS_WAIT = Duration(seconds=1)
"""Time after a client's feedback in which other clients' feedback is ignored."""


class _Callbacks:
    """Callbacks of a marker."""

    def __init__(self) -> None:
        self.default_feedback_callback: Callback | None = None
        self.feedback_callbacks: dict[int, Callback] = {}
        """By the type of feedback."""
        self.int_marker = InteractiveMarker()

    def set_callback(self, callback: Callback | None, feedback_type: int) -> None:
        """Set the callback of a type of feedback, or the default; None removes it."""
        if feedback_type == InteractiveMarkerServer.DEFAULT_FEEDBACK_CALLBACK:
            self.default_feedback_callback = callback
        elif callback is not None:
            self.feedback_callbacks[feedback_type] = callback
        else:
            self.feedback_callbacks.pop(feedback_type, None)


class MarkerContext(_Callbacks):
    """A published marker."""

    def __init__(self, time: Time) -> None:
        super().__init__()
        self.last_feedback = time
        self.last_client_id = ""


class UpdateContext(_Callbacks):
    """An unpublished change of a marker."""

    FULL_UPDATE = 0
    POSE_UPDATE = 1
    ERASE = 2

    def __init__(self) -> None:
        super().__init__()
        self.update_type = self.FULL_UPDATE


class InteractiveMarkerServer:
    """Publishes markers for clients such as RViz, and calls callbacks when users move or click them.

    `applyChanges` publishes the changes by `insert`, `setPose`, `erase` and `clear`. The node's executor processes
    feedback; methods may be called from any thread.

    Args:
        node: Owns the publisher `<namespace>/update`, the subscription `<namespace>/feedback` and the service
            `<namespace>/get_interactive_markers`.
        namespace: Namespace of the topics and the service, which clients use, too.
        update_pub_qos: Quality of service of the publisher; None: reliable, depth 100.
        feedback_sub_qos: Quality of service of the subscription; None: reliable, depth 1.
    """

    DEFAULT_FEEDBACK_CALLBACK = 255
    """The type of the default callback, for feedback of types without a callback."""

    def __init__(
        self,
        node: Node,
        namespace: str,
        *,
        update_pub_qos: QoSProfile | None = None,
        feedback_sub_qos: QoSProfile | None = None,
    ) -> None:
        self.node = node
        self.namespace = namespace
        self.seq_num = 0
        self.mutex = Lock()
        """Guards `marker_contexts`, `pending_updates` and `seq_num`; no callback runs under it."""
        self.marker_contexts: dict[str, MarkerContext] = {}
        self.pending_updates: dict[str, UpdateContext] = {}
        self.get_interactive_markers_srv = node.create_service(
            GetInteractiveMarkers, f"{namespace}/get_interactive_markers", self.getInteractiveMarkersCallback
        )
        self.update_pub = node.create_publisher(
            InteractiveMarkerUpdate, f"{namespace}/update", update_pub_qos or QoSProfile(depth=100)
        )
        self.feedback_sub = node.create_subscription(
            InteractiveMarkerFeedback,
            f"{namespace}/feedback",
            self.processFeedback,
            feedback_sub_qos or QoSProfile(depth=1),
        )
        self._is_shut_down = False

    def shutdown(self) -> None:
        """Erase all markers and destroy the server's endpoints. Call it before the node is destroyed."""
        if self._is_shut_down:
            return
        self._is_shut_down = True
        if self.node.context.ok():
            self.clear()
            self.applyChanges()
        self.node.destroy_service(self.get_interactive_markers_srv)
        self.node.destroy_publisher(self.update_pub)
        self.node.destroy_subscription(self.feedback_sub)

    def __del__(self) -> None:
        # The constructor may have failed, or the node may be destroyed.
        with contextlib.suppress(Exception):
            self.shutdown()

    def insert(
        self,
        marker: InteractiveMarker,
        *,
        feedback_callback: Callback | None = None,
        feedback_type: int = DEFAULT_FEEDBACK_CALLBACK,
    ) -> None:
        """Add a marker, or replace the marker of the same name.

        Args:
            marker: The marker.
            feedback_callback: Called with each feedback, on a thread of the executor; effective at once.
            feedback_type: Type of feedback for which it is called, as InteractiveMarkerFeedback.MENU_SELECT.
        """
        with self.mutex:
            update = self.pending_updates.setdefault(marker.name, UpdateContext())
            update.update_type = UpdateContext.FULL_UPDATE
            update.int_marker = marker
        if feedback_callback is not None:
            self.setCallback(marker.name, feedback_callback, feedback_type)

    def setPose(self, name: str, pose: Pose, header: Header | None = None) -> bool:
        """Change the pose of a published marker, and return whether the marker exists.

        Args:
            name: The marker.
            pose: Its new pose.
            header: Its new header; None, or a header without a frame: unchanged.
        """
        with self.mutex:
            context, update = self.marker_contexts.get(name), self.pending_updates.get(name)
            # A pending full update replaces the marker, with its own pose.
            if context is None or (update is not None and update.update_type == UpdateContext.FULL_UPDATE):
                return False
            if header is None or not header.frame_id:
                header = context.int_marker.header
            self._set_pose(update, name, pose, header)
            return True

    def _set_pose(self, update: UpdateContext | None, name: str, pose: Pose, header: Header) -> None:
        if update is None:
            update = self.pending_updates[name] = UpdateContext()
            update.update_type = UpdateContext.POSE_UPDATE
        elif update.update_type != UpdateContext.FULL_UPDATE:
            update.update_type = UpdateContext.POSE_UPDATE
        update.int_marker.pose = pose
        update.int_marker.header = header

    def doSetPose(self, update: UpdateContext | None, name: str, pose: Pose, header: Header) -> None:
        """Record a new pose of a marker; the caller holds the lock.

        Args:
            update: The marker's pending change, if any.
            name: The marker.
            pose: Its new pose.
            header: Its header.
        """
        self._set_pose(update, name, pose, header)

    def erase(self, name: str) -> bool:
        """Remove a marker, and return whether it existed."""
        with self.mutex:
            return self._erase(name)

    def _erase(self, name: str) -> bool:
        if name not in self.pending_updates and name not in self.marker_contexts:
            return False
        self.pending_updates.setdefault(name, UpdateContext()).update_type = UpdateContext.ERASE
        return True

    def clear(self) -> None:
        """Remove all markers."""
        with self.mutex:
            # Markers that were never published vanish with their updates; the published ones must be erased at the
            # clients.
            self.pending_updates = {}
            for name in self.marker_contexts:
                self._erase(name)

    def setCallback(
        self,
        name: str,
        feedback_callback: Callback | None,
        feedback_type: int = DEFAULT_FEEDBACK_CALLBACK,
    ) -> bool:
        """Set a marker's callback, effective at once, and return whether the marker exists.

        Args:
            name: The marker.
            feedback_callback: Called with each feedback, on a thread of the executor; None removes it.
            feedback_type: Type of feedback for which it is called, in place of the default callback.
        """
        with self.mutex:
            targets = [
                target
                for target in (self.marker_contexts.get(name), self.pending_updates.get(name))
                if target is not None
            ]
            for target in targets:
                target.set_callback(feedback_callback, feedback_type)
            return bool(targets)

    def applyChanges(self) -> None:
        """Publish the changes since the last call, if any."""
        with self.mutex:
            if not self.pending_updates:
                return
            message = InteractiveMarkerUpdate(type=InteractiveMarkerUpdate.UPDATE)
            for name, update in self.pending_updates.items():
                self._apply(name, update, message)
            # Publish under the lock, so that messages leave in the order of their numbers. No user's code runs there.
            self.pending_updates = {}
            self.seq_num += 1
            self.publish(message)

    def _apply(self, name: str, update: UpdateContext, message: InteractiveMarkerUpdate) -> None:
        """Apply a change to a marker, and add it to a message."""
        context = self.marker_contexts.get(name)
        if update.update_type == UpdateContext.ERASE:
            if self.marker_contexts.pop(name, None) is not None:
                message.erases.append(name)
        elif update.update_type == UpdateContext.FULL_UPDATE:
            if context is None:
                self.node.get_logger().debug(f"Creating new context for {name}")
                context = self.marker_contexts[name] = MarkerContext(self.node.get_clock().now())
                context.default_feedback_callback = update.default_feedback_callback
                context.feedback_callbacks = update.feedback_callbacks
            context.int_marker = update.int_marker
            message.markers.append(update.int_marker)
        elif context is not None:
            marker = context.int_marker
            marker.pose, marker.header = update.int_marker.pose, update.int_marker.header
            message.poses.append(
                InteractiveMarkerPose(header=marker.header, pose=marker.pose, name=marker.name)
            )

    def get(self, name: str) -> InteractiveMarker | None:
        """Return a marker with its pending changes; None if it does not exist."""
        with self.mutex:
            context, update = self.marker_contexts.get(name), self.pending_updates.get(name)
            if update is None:
                return None if context is None else context.int_marker
            if update.update_type == UpdateContext.FULL_UPDATE:
                return update.int_marker
            if update.update_type == UpdateContext.ERASE or context is None:
                return None
            marker = copy.copy(context.int_marker)
            marker.pose, marker.header = update.int_marker.pose, update.int_marker.header
            return marker

    def processFeedback(self, feedback: InteractiveMarkerFeedback) -> None:
        """Process feedback: change the marker's pose, call the callback, publish the changes."""
        with self.mutex:
            context = self.marker_contexts.get(feedback.marker_name)
            if context is None:
                return
            now = self.node.get_clock().now()
            # Two users who drag one marker would make it jump: the first one has it until its feedback pauses.
            others = context.last_client_id not in {"", feedback.client_id}
            if others and now - context.last_feedback < _OTHERS_WAIT:
                self.node.get_logger().debug(
                    f"Rejecting feedback for '{feedback.marker_name}': conflicting feedback from separate clients"
                )
                return
            context.last_feedback, context.last_client_id = now, feedback.client_id
            if feedback.event_type == InteractiveMarkerFeedback.POSE_UPDATE:
                # A marker with a stamp of 0 moves with its frame; this stays so.
                kept = context.int_marker.header
                header = kept if kept.stamp == TimeMessage() else feedback.header
                update = self.pending_updates.get(feedback.marker_name)
                self._set_pose(update, feedback.marker_name, feedback.pose, header)
            callback = context.feedback_callbacks.get(feedback.event_type, context.default_feedback_callback)
        try:
            if callback is not None:
                callback(feedback)
        finally:  # the user has moved the marker, whatever the callback does
            self.applyChanges()

    def publish(self, update: InteractiveMarkerUpdate) -> None:
        """Publish an update under the current sequence number."""
        update.seq_num = self.seq_num
        self.update_pub.publish(update)

    def getInteractiveMarkersCallback(
        self,
        request: GetInteractiveMarkers.Request,  # noqa: ARG002  # it is empty
        response: GetInteractiveMarkers.Response,
    ) -> GetInteractiveMarkers.Response:
        """Reply with all published markers."""
        with self.mutex:
            response.sequence_number = self.seq_num
            self.node.get_logger().debug("Markers requested. Responding with the following markers:")
            for name, context in self.marker_contexts.items():
                self.node.get_logger().debug(f"    {name}")
                response.markers.append(context.int_marker)
        return response

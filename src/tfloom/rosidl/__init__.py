"""Message types: definitions, type hashes, Python classes and the codec.

- definitions/: the common packages' files, read by generate, which writes `tfloom.interfaces`
- parse, spec, references, type_hash: a definition, and the hash of its type
- message, cdr, fill: objects of messages, their bytes, their fields from plain values
- yaml_text: messages as text, and from a user's
- adapter: rosidl_adapter.parser
- dynamic, definition_modules: types at run time; class_modules: the modules that classes name as theirs
- idl_tokens, idl_values, idl_reader, idl_types, idl_parser, idl_spec: .idl files
"""

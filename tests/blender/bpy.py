"""Stands in for Blender where it is not: classes are registered, properties have their defaults, panels remember what was
drawn. As much of its interface as the add-on uses."""

import os
import types as _types

registered = []


class _Property:
    def __init__(self, kind, **said):
        self.kind, self.said = kind, said


class _Types:
    class AddonPreferences:
        pass

    class PropertyGroup:
        """An instance has each property's default, and refuses what an enumeration does not have."""

        def __init__(self):
            for name, one in type(self).__annotations__.items():
                items = one.said.get("items")
                object.__setattr__(self, name, one.said.get("default", items[0][0] if items else ""))

        def __setattr__(self, name, value):
            one = type(self).__annotations__[name]
            items = one.said.get("items")
            if items and value not in [item[0] for item in items]:
                raise TypeError(f"{name} has no item {value}")
            object.__setattr__(self, name, value)

    class Scene:
        pass


types = _Types()
props = _types.SimpleNamespace(
    **{kind: (lambda kind: lambda **said: _Property(kind, **said))(kind)
       for kind in ["StringProperty", "BoolProperty", "EnumProperty", "PointerProperty"]}
)


def _register(one):
    if not issubclass(one, (_Types.AddonPreferences, _Types.PropertyGroup)):
        raise TypeError(f"{one} can not be registered")
    for name, prop in one.__annotations__.items():
        if not prop.said.get("name"):
            raise TypeError(f"{name} has no name")
    registered.append(one)


utils = _types.SimpleNamespace(register_class=_register, unregister_class=registered.remove)
path = _types.SimpleNamespace(abspath=os.path.abspath)


def begin(addon, program=""):
    """A new scene, with the add-on's properties, in a Blender whose preferences name the program."""
    scene = _types.SimpleNamespace(foredraw=_Types.Scene.foredraw.said["type"]())
    preferences = _types.SimpleNamespace(preferences=_types.SimpleNamespace(program=program))
    context.scene = scene
    context.preferences = _types.SimpleNamespace(addons={addon.__name__: preferences})


context = _types.SimpleNamespace()


class Layout:
    """Remembers the properties and labels that were drawn."""

    def __init__(self, is_open=True):
        self.drawn, self.is_open = [], is_open

    def panel(self, _name, default_closed):
        return self, self if self.is_open else None

    def prop(self, owner, name):
        getattr(owner, name)
        self.drawn.append(name)

    def label(self, text):
        self.drawn.append(text)

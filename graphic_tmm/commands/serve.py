"""serve: a scene, or a folder of scenes, in the browser; it follows the files as they are edited."""

from __future__ import annotations

import click

from graphic_tmm.commands.shared.options import SceneName
from graphic_tmm.commands.shared.spoken import Command
from graphic_tmm.commands.shared.telling import tell
from graphic_tmm.language.said import said


@click.command(cls=Command)
@click.argument("scene", required=False, type=SceneName())
@click.option("--host", default="127.0.0.1", show_default=True, help=said("Address to listen at."))
@click.option(
    "--port",
    type=click.IntRange(0, 65_535),
    default=0,
    show_default=True,
    help=said("Port to listen at; 0: one that is free."),
)
def serve(scene: str | None, host: str, port: int) -> None:
    """Serve SCENE, or all scenes of a folder, to a browser; what is edited is drawn again at once."""
    from graphic_tmm.language.reader import asked_language
    from graphic_tmm.serve.extra import served
    from graphic_tmm.serve.limits import LOOPBACK

    if host not in LOOPBACK:
        tell(
            said(
                "--host {host}: whoever knows the address below can read and change these scenes from "
                "other computers; it goes over the network as it is",
                host=host,
            )
        )
    served(scene, host=host, port=port, language=asked_language(), tell=click.echo)

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
@click.option(
    "--browser", is_flag=True, help=said("Open the address in the browser of this computer, too.")
)
def serve(scene: str | None, host: str, port: int, browser: bool) -> None:
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
    served(
        scene,
        host=host,
        port=port,
        language=asked_language(),
        tell=_opened if browser else click.echo,
    )


def _opened(address: str) -> None:
    """Print the address of the studio, and open it: the server goes on while a browser begins."""
    import webbrowser
    from threading import Thread

    click.echo(address)
    tell(said("the studio is in the browser; Ctrl-C, or closing this window, ends it"))
    Thread(target=webbrowser.open, args=(address,), daemon=True).start()

// SPDX-License-Identifier: MIT
// Requests of a page to the server that has served it.
export const token = new URLSearchParams(location.search).get("token") ?? "";

export async function ask(path, body) {
    const answer = await fetch(path, {
        method: body === undefined ? "GET" : "POST",
        body: body === undefined ? undefined : JSON.stringify(body),
        headers: {"X-Grafverif-Token": token},
        cache: "no-store",
    });
    if (!answer.ok) throw new Error((await answer.text()).trim());
    return answer.json();
}
